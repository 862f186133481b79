package org.maestro.knowledge;

/**
 * Who says something, and how sure it is of what it says.
 *
 * @param confidence 0 (worthless) to 1 (certain)
 */
record Voice(Source source, double confidence) {

  boolean expects() {
    return source.kind() == Source.Kind.EXPECTED;
  }
}
