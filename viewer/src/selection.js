// Which cause and which of its hazards are selected, told to whoever asks, and kept in the address so that a link leads to it.

const idOfHash = () => {
  try {
    return decodeURIComponent(location.hash.slice(1));
  } catch {
    return location.hash.slice(1);
  }
};

/** The selection among causes and their hazards; the worst is selected unless the address names another. */
export function makeSelection(causes) {
  const causeOf = new Map(causes.flatMap((cause) => cause.hazards.map((id) => [id, cause.id])));
  const worstOf = new Map(causes.map((cause) => [cause.id, cause.worst]));
  const known = (id) => causeOf.has(id) || worstOf.has(id);
  const both = (id) => (worstOf.has(id) ? { cause: id, hazard: worstOf.get(id) } : { cause: causeOf.get(id), hazard: id });
  const listeners = [];
  const first = known(idOfHash()) ? idOfHash() : causes[0]?.id;
  let current = first === undefined ? { cause: null, hazard: null } : both(first);

  function change(id) {
    const next = both(id);
    if (next.hazard !== current.hazard) {
      current = next;
      listeners.forEach((listener) => listener(current));
    }
  }

  addEventListener("hashchange", () => {
    if (known(idOfHash())) {
      change(idOfHash());
    }
  });

  return {
    /** Ids of the selected hazard and of its cause. */
    get now() {
      return current;
    },
    /** Whether the address names one hazard, not a whole cause. */
    get namesHazard() {
      return causeOf.has(idOfHash());
    },
    /** An id in the address that is none of this report. */
    get unknown() {
      const id = idOfHash();
      return /^[CH]-/.test(id) && !known(id) ? id : null;
    },
    /** Selects a cause, and with it its worst hazard, or a hazard; the history does not grow with every look at another. */
    select(id) {
      history.replaceState(null, "", `#${encodeURIComponent(id)}`);
      change(id);
    },
    /** Hears of each change, and at once of what is selected now: ids of cause and hazard. */
    follow(listener) {
      listeners.push(listener);
      if (current.hazard !== null) {
        listener(current);
      }
    },
  };
}
