package org.maestro.language.wording;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.language.grammar.Grammar;

/**
 * The verbs of patterns of constructions, in their base forms: where they stand, and how what is
 * parted from them is joined to them. Immutable.
 */
final class Verbs {
  private static final Pattern ROLE = Pattern.compile("\\{(\\w+)}");
  private static final Pattern MAY_BE_LEFT_OUT = Pattern.compile("[\\[(|]");
  private static final String PARTED = "-";

  private final Grammar grammar;
  private final boolean last;

  Verbs(Grammar grammar) {
    this.grammar = grammar;
    this.last = grammar.list("verb-place").contains(List.of("last"));
  }

  /** Whether the verb stands last in a pattern, else first. */
  boolean areLast() {
    return last;
  }

  /** The pattern in which the verb is one word with what may be parted from it. */
  String joined(String said) {
    int verb = said.lastIndexOf(' ') + 1;
    return last ? said.substring(0, verb) + said.substring(verb).replace(PARTED, "") : said;
  }

  /** Each word, also of what may be parted. */
  static Stream<String> words(String said) {
    return Arrays.stream(said.split("[ -]"));
  }

  /** Whether something of it may be left out, or said otherwise. */
  static boolean isOptional(String said) {
    return MAY_BE_LEFT_OUT.matcher(said).find();
  }

  /** Whether its verb is no wish and stands where it should, and it has just these roles. */
  boolean isSayable(String said, Set<String> roles) {
    Set<String> places =
        ROLE.matcher(said).results().map(r -> r.group(1)).collect(Collectors.toSet());
    String verb = last ? said.substring(said.lastIndexOf(' ') + 1) : said.split(" ")[0];
    return places.equals(roles)
        && !verb.startsWith("{")
        && !isOptional(said)
        && !grammar.list("want").contains(List.of(verb));
  }
}
