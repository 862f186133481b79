package org.maestro.language.reference;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.language.grammar.Form;
import org.maestro.sl.Term;

/**
 * What was spoken of, the latest first (A65), and what was asked back last. Immutable.
 *
 * @param things individuals
 * @param classes kinds of things
 * @param group several things that were spoken of together last
 * @param last what was said last, as far as it was understood
 * @param asked what was asked back then
 */
public record Discourse(
    List<Term.Name> things,
    List<String> classes,
    List<Term.Name> group,
    Optional<Form> last,
    Optional<Asked> asked) {
  /** Nothing was said before. */
  public static final Discourse NONE =
      new Discourse(List.of(), List.of(), List.of(), Optional.empty(), Optional.empty());

  private static final int REMEMBERED = 30;

  /**
   * A question back.
   *
   * @param role which was missing
   * @param phrase that could be several things, or none; neither: whether it is to be done
   */
  public record Asked(Optional<String> role, Optional<Form> phrase) {}

  public Discourse {
    things = List.copyOf(things);
    classes = List.copyOf(classes);
    group = List.copyOf(group);
  }

  /** After these were spoken of. */
  public Discourse with(List<Term.Name> others, List<String> kinds, List<Term.Name> together) {
    return new Discourse(
        latest(others, things),
        latest(kinds, classes),
        together.isEmpty() ? group : together,
        last,
        asked);
  }

  /** After this was said, and this asked back. */
  public Discourse saying(Form said, Optional<Asked> question) {
    return new Discourse(things, classes, group, Optional.of(said), question);
  }

  private static <T> List<T> latest(List<T> now, List<T> before) {
    Set<T> all = new LinkedHashSet<>(now);
    all.addAll(before);
    List<T> kept = new ArrayList<>(all);
    return kept.size() > REMEMBERED ? kept.subList(0, REMEMBERED) : kept;
  }
}
