// Numbers as the report writes them where they change while somebody looks: at a frame of a replay, in a bin of the map, under a filter.
// All sentences are in the data of the page.

/** A ratio, as in "1.33x". */
export const ratio = (value) => `${value.toFixed(2)}x`;

/** A time. */
export const time = (value) => `${value.toFixed(2)} s`;

/** A count with its noun; its thousands are set apart. */
export const count = (number, noun) => `${String(number).replace(/\B(?=(\d{3})+(?!\d))/g, ",")} ${noun}${number === 1 ? "" : "s"}`;
