package org.maestro.console.history;

import java.util.Locale;

/** Who answers, and is measured by how soon. */
public enum Answerer {
  /** The console's API. */
  API,
  /** The platform's agents, when the console asks who is there. */
  AGENTS,
  /** Members, from a call on the bus to their first word on it. */
  MEMBERS;

  /** The name of the series. */
  String series() {
    return name().toLowerCase(Locale.ROOT) + "-answers";
  }
}
