package org.maestro.coordination.scripts;

/** The places of parts in a script: numbers with dots between them; the whole has none. */
final class Place {
  private Place() {}

  /** Of what is in the part, counted from 1. */
  static String below(String path, int number) {
    return path.isEmpty() ? String.valueOf(number) : path + "." + number;
  }
}
