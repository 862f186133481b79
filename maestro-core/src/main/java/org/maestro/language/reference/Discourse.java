package org.maestro.language.reference;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.maestro.sl.Term;

/**
 * What was spoken of, the latest first (A65). Immutable.
 *
 * @param things individuals
 * @param classes kinds of things
 */
public record Discourse(List<Term.Name> things, List<String> classes) {
  /** Nothing was said before. */
  public static final Discourse NONE = new Discourse(List.of(), List.of());

  private static final int REMEMBERED = 30;

  public Discourse {
    things = List.copyOf(things);
    classes = List.copyOf(classes);
  }

  /** After these were spoken of. */
  public Discourse with(List<Term.Name> others, List<String> kinds) {
    return new Discourse(latest(others, things), latest(kinds, classes));
  }

  private static <T> List<T> latest(List<T> now, List<T> before) {
    Set<T> all = new LinkedHashSet<>(now);
    all.addAll(before);
    List<T> kept = new ArrayList<>(all);
    return kept.size() > REMEMBERED ? kept.subList(0, REMEMBERED) : kept;
  }
}
