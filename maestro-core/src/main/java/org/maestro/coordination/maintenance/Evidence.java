package org.maestro.coordination.maintenance;

/** The evidence by which a held goal counts as so. */
enum Evidence {
  /** What is observed without a break. */
  OBSERVED,
  /** What is known, since nobody can observe it all the time. */
  KNOWN
}
