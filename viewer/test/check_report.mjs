// Checks reports from the command line: node check_report.mjs [--main] report.html [more.html]
// With --main only what shows soonest that a report works: picture, scrubber, selection, links, form.

import { checkReport, withBrowsers } from "./report.mjs";

const onlyMain = process.argv[2] === "--main";
const files = process.argv.slice(onlyMain ? 3 : 2);
if (files.length === 0) {
  console.error("usage: node check_report.mjs [--main] report.html [more.html]");
  process.exit(2);
}

let failed = 0;
await withBrowsers(async (browsers) => {
  for (const file of files) {
    console.log(file);
    await checkReport(file, browsers, (name, error) => {
      console.log(`  ${error ? "FAILED" : "ok"}  ${name}`);
      if (error) {
        failed += 1;
        console.log(`${error.message}`.replace(/^/gm, "          "));
      }
    }, onlyMain);
  }
});
console.log(failed === 0 ? "All checks passed." : `${failed} checks failed.`);
process.exitCode = failed === 0 ? 0 : 1;
