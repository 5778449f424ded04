// Checks reports from the command line: node check_report.mjs [--main | --quick | --flat] report.html [more.html]
// With --main only what shows soonest that a report works: picture, scrubber, selection, links, form. With --quick those, and one of four
// of the others, by FMI_HAZARD_SAMPLE as in src/sample.rs. With --flat only those that need no 3-D graphics.

import { CHECKS, checkReport, withBrowsers } from "./report.mjs";

const sample = process.env.FMI_HAZARD_SAMPLE ?? "0";
const needsNone = ({ flat = false, graphics = true }) => flat || !graphics;
const others = CHECKS.filter((check) => !check.main);
const inSample = (check) => sample === "all" || others.indexOf(check) % 4 === Number(sample) % 4;

const WANTED = {
  "--main": ({ main = false }) => main,
  "--quick": (check) => check.main || inSample(check),
  "--flat": needsNone,
};
const option = process.argv[2] in WANTED ? process.argv[2] : null;
const files = process.argv.slice(option === null ? 2 : 3);
if (files.length === 0) {
  console.error("usage: node check_report.mjs [--main | --quick | --flat] report.html [more.html]");
  process.exit(2);
}

let failed = 0;
await withBrowsers(async (browsers) => {
  for (const file of files) {
    console.log(file);
    const hear = (name, error) => {
      console.log(`  ${error ? "FAILED" : "ok"}  ${name}`);
      if (error) {
        failed += 1;
        console.log(`${error.message}`.replace(/^/gm, "          "));
      }
    };
    const quick = option === "--quick" || option === "--flat";
    await checkReport(file, browsers, hear, { quick, ...(option === null ? {} : { wanted: WANTED[option] }) });
  }
});
console.log(failed === 0 ? "All checks passed." : `${failed} checks failed.`);
process.exitCode = failed === 0 ? 0 : 1;
