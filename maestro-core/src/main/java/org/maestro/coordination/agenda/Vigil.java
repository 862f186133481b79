package org.maestro.coordination.agenda;

import org.maestro.coordination.facts.FactFilter;

/** What is done while a time or an event is awaited. The coordinator's thread only. */
interface Vigil {

  void start();

  /** The same after a restart, of which the entry knows. */
  void takeUp();

  default void knowledgeChanged(FactFilter changed) {
    // Times come by themselves.
  }

  default void memberLost() {
    // Times come whoever is there.
  }
}
