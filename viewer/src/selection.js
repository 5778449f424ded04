// Which hazard is selected, told to whoever asks, and kept in the address so that a link leads to it.

const idOfHash = () => {
  try {
    return decodeURIComponent(location.hash.slice(1));
  } catch {
    return location.hash.slice(1);
  }
};

/** The selection among these ids; the first is selected unless the address names another. */
export function makeSelection(ids) {
  const known = new Set(ids);
  const listeners = [];
  let current = known.has(idOfHash()) ? idOfHash() : (ids[0] ?? null);

  function change(id) {
    if (id !== current) {
      current = id;
      listeners.forEach((listener) => listener(id));
    }
  }

  addEventListener("hashchange", () => {
    if (known.has(idOfHash())) {
      change(idOfHash());
    }
  });

  return {
    get id() {
      return current;
    },
    /** An id in the address that is none of this report. */
    get unknown() {
      const id = idOfHash();
      return id.startsWith("H-") && !known.has(id) ? id : null;
    },
    /** Selects a hazard; the history does not grow with every look at another row. */
    select(id) {
      history.replaceState(null, "", `#${encodeURIComponent(id)}`);
      change(id);
    },
    /** Hears of each change, and at once of what is selected now. */
    follow(listener) {
      listeners.push(listener);
      if (current !== null) {
        listener(current);
      }
    },
  };
}
