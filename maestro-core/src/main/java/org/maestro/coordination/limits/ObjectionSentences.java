package org.maestro.coordination.limits;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.permission.Objection;
import org.maestro.ontology.permission.Way;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Puts into sentences why something is not done for a person, by labels. */
final class ObjectionSentences {
  private static final Pattern PLACE_HOLDER = Pattern.compile("\\{([A-Za-z][A-Za-z0-9-]*)}");

  private final Home home;

  ObjectionSentences(Home home) {
    this.home = home;
  }

  /** What the person may, who else may do more, and where that is stated. */
  String of(Objection objection) {
    return "%s%s. That is stated by %s%s."
        .formatted(
            capitalized(shortly(objection)),
            others(objection),
            String.join(" and ", objection.permissions()),
            inFile());
  }

  /**
   * Within what plans are made for a person.
   *
   * @param permissions names of those that count
   */
  String within(Optional<String> person, Set<String> permissions) {
    return "For %s it is planned within what is stated by %s%s."
        .formatted(
            person.map(this::label).orElse("who is not known"),
            String.join(" and ", permissions),
            inFile());
  }

  private String inFile() {
    return home.file().map(file -> " in " + file).orElse("");
  }

  /** What the person may, as a part of a sentence. */
  String shortly(Objection objection) {
    String who = objection.person().map(this::label).orElse("who is not known");
    return objection
        .limit()
        .map(limit -> "%s may set %s to %s".formatted(who, what(limit), number(limit)))
        .orElseGet(() -> "for %s it may not be that %s".formatted(who, sentence(objection.way())));
  }

  private String others(Objection objection) {
    List<String> names = objection.others().stream().map(this::label).toList();
    if (names.isEmpty()) {
      return "";
    }
    String all =
        names.size() == 1
            ? names.get(0)
            : String.join(", ", names.subList(0, names.size() - 1))
                + " or "
                + names.get(names.size() - 1);
    return objection
        .limit()
        .map(limit -> "; %s may set it so".formatted(all))
        .orElse("; for %s it may".formatted(all));
  }

  private String what(Objection.Limit limit) {
    String fluent =
        home.vocabulary()
            .predicate(limit.what().name())
            .map(PredicateDeclaration::label)
            .orElse(limit.what().name());
    String whose =
        limit.what().arguments().stream().map(this::term).collect(Collectors.joining(" and "));
    return "the %s of %s".formatted(fluent, whose);
  }

  private static String number(Objection.Limit limit) {
    String number = SlPrinter.print(limit.number());
    return limit.relation() == Formula.Relation.EQUAL
        ? number + " only"
        : limit.relation().inWords() + " " + number;
  }

  private String sentence(Way way) {
    Matcher places = PLACE_HOLDER.matcher(way.feature().sentence());
    return places.replaceAll(
        found -> {
          String name = found.group(1);
          Term value =
              name.equals(Self.NAME) ? new Term.Name(way.device().id()) : way.values().get(name);
          return Matcher.quoteReplacement(
              Optional.ofNullable(value).map(this::term).orElse("anything"));
        });
  }

  private String term(Term term) {
    return term instanceof Term.Name name ? label(name.text()) : SlPrinter.print(term);
  }

  private String label(String name) {
    return Optional.ofNullable(home.individuals().get(name)).map(Individual::label).orElse(name);
  }

  private static String capitalized(String text) {
    return text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
  }
}
