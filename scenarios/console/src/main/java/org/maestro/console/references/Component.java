package org.maestro.console.references;

/**
 * What one agent does of one kind; an agent that does several kinds of things is several of them.
 *
 * @param agent its name
 * @param container in which it lives
 */
record Component(String agent, String container, Faculty faculty) {
  /** Unique on a platform, such as {@code CCA/cognition}. */
  String id() {
    return agent + "/" + faculty.word();
  }
}
