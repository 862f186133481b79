package org.maestro.language.wording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.Said;
import org.maestro.sl.Self;

/**
 * What reports speak of: things, numbers, words of the vocabulary and steps of its features, each
 * as it is written in reports. Immutable.
 */
final class ReportedTerms {
  private static final Pattern NAME = Pattern.compile("[^\\s,;:()]+");
  private static final Pattern GOAL = Pattern.compile("G\\d+(\\.\\d+)*");
  private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?(E-?\\d+)?");
  private static final Pattern PLACE = Pattern.compile("\\{([\\w-]+)}");

  private final Home home;
  private final Grammar grammar;
  private final Phrases phrases;
  private final Naming naming;
  private final Function<String, Optional<String>> formulas;
  private final Map<String, String> things = new HashMap<>();
  private final Map<String, String> relations = new HashMap<>();
  private final Map<String, String> abilities = new HashMap<>();
  private final Map<String, String> fluents = new HashMap<>();
  private final Map<String, String> classes = new HashMap<>();
  private final Set<String> units = new HashSet<>();
  private final List<Step> steps = new ArrayList<>();

  /** What is told of a feature's steps, there and here. */
  private record Step(Pattern told, List<String> names, String here) {}

  /**
   * @param formulas what a text in MAESTRO-SL says; empty when it says nothing for which there are
   *     words
   */
  ReportedTerms(Home home, Grammar grammar, Function<String, Optional<String>> formulas) {
    this.home = home;
    this.grammar = grammar;
    this.phrases = new Phrases(grammar);
    this.naming = new Naming(home, grammar);
    this.formulas = formulas;
    home.individuals().forEach((id, one) -> things.putIfAbsent(one.label(), id));
    home.individuals().keySet().forEach(id -> things.put(id, id));
    for (PredicateDeclaration one : home.vocabulary().predicates().values()) {
      (one.fluent() ? fluents : relations).put(one.label(), one.name());
      units.add(one.unitAfterNumber());
      if (!one.fluent() && one.label().contains(" ")) {
        abilities.put(one.label().substring(one.label().indexOf(' ') + 1), one.name());
      }
    }
    home.vocabulary().classes().values().forEach(one -> classes.put(one.label(), one.name()));
    home.vocabulary().features().values().forEach(this::add);
  }

  private void add(FeatureType feature) {
    in(home.wording().told().getOrDefault(feature.name(), List.of()))
        .ifPresent(here -> steps.add(step(feature, here)));
  }

  private static Step step(FeatureType feature, String here) {
    List<String> names = new ArrayList<>();
    StringBuilder pattern = new StringBuilder();
    Matcher places = PLACE.matcher(feature.sentence());
    int at = 0;
    while (places.find()) {
      names.add(places.group(1));
      pattern.append(Pattern.quote(feature.sentence().substring(at, places.start())));
      pattern.append("(.+?)");
      at = places.end();
    }
    pattern.append(Pattern.quote(feature.sentence().substring(at)));
    return new Step(Pattern.compile(pattern.toString()), names, here);
  }

  private Optional<String> in(List<Said> said) {
    return said.stream().filter(one -> one.isIn(grammar.language())).map(Said::text).findFirst();
  }

  /** A part of a report; empty when it is no such thing. */
  Optional<Reported> of(String category, String text) {
    return switch (category) {
      case "thing" -> thing(text);
      case "things" -> listed(text);
      case "name" -> matching(NAME, text).map(name -> Reported.named(naming.word(name), name));
      case "goal" -> goal(text);
      case "number" -> number(text);
      case "value" -> value(text);
      case "ability" -> Optional.ofNullable(abilities.get(text)).map(this::named);
      case "relation" -> Optional.ofNullable(relations.get(text)).map(this::named);
      case "fluent" ->
          Optional.ofNullable(fluents.get(text)).filter(naming::isNamed).map(this::named);
      case "class" -> Optional.ofNullable(classes.get(text)).map(this::named);
      case "feature" ->
          Optional.of(text)
              .filter(home.vocabulary().features()::containsKey)
              .filter(naming::isNamed)
              .map(this::named);
      case "formula" -> formulas.apply(text).map(Reported::of);
      case "step" -> step(text);
      case "words" -> Optional.of(Reported.of(text));
      default -> Optional.empty();
    };
  }

  private static Optional<String> matching(Pattern pattern, String text) {
    return Optional.of(text).filter(one -> pattern.matcher(one).matches());
  }

  private Reported named(String name) {
    return Reported.named(naming.word(name), name);
  }

  private Optional<Reported> thing(String text) {
    return Optional.ofNullable(things.get(text)).map(this::named);
  }

  /** Several, with a comma between any two. */
  private Optional<Reported> listed(String text) {
    List<Optional<Reported>> all =
        List.of(text.split(", ")).stream().map(this::valueOrThing).toList();
    return all.stream().allMatch(Optional::isPresent)
        ? Optional.of(
            Reported.named(
                phrases.listed(all.stream().map(one -> one.get().text()).toList()),
                all.stream().map(one -> one.get().symbol()).collect(Collectors.joining(" "))))
        : Optional.empty();
  }

  private Optional<Reported> valueOrThing(String text) {
    return thing(text).or(() -> quoted(text));
  }

  private static Optional<Reported> quoted(String text) {
    return text.matches("\"[^\"]*\"")
        ? Optional.of(Reported.named(text.substring(1, text.length() - 1), text))
        : Optional.empty();
  }

  /** Goals have no names that people know. */
  private Optional<Reported> goal(String text) {
    String instead = phrases.of("all-doing");
    return text.equals(instead) || GOAL.matcher(text).matches()
        ? Optional.of(Reported.of(instead))
        : Optional.empty();
  }

  private Optional<Reported> number(String text) {
    return matching(NUMBER, text)
        .map(one -> Reported.named(one.replace(".", phrases.of("decimal-mark")), one));
  }

  /** A number with its unit, a thing, or words. */
  private Optional<Reported> value(String text) {
    return units.stream()
        .filter(text::endsWith)
        .map(unit -> amount(text.substring(0, text.length() - unit.length()), unit))
        .flatMap(Optional::stream)
        .findFirst()
        .or(() -> valueOrThing(text));
  }

  private Optional<Reported> amount(String number, String unit) {
    return number(number).map(one -> Reported.named(one.text() + unit, one.symbol()));
  }

  private Optional<Reported> step(String text) {
    return steps.stream().map(step -> step(step, text)).flatMap(Optional::stream).findFirst();
  }

  private Optional<Reported> step(Step step, String text) {
    Matcher told = step.told().matcher(text);
    if (!told.matches()) {
      return Optional.empty();
    }
    Map<String, String> values = new HashMap<>();
    for (int i = 0; i < step.names().size(); i++) {
      String value = told.group(i + 1);
      Optional<Reported> read =
          step.names().get(i).equals(Self.NAME) ? thing(value) : valueOrAnything(value);
      if (read.isEmpty()) {
        return Optional.empty();
      }
      values.put(step.names().get(i), read.get().text());
    }
    return Optional.of(Reported.of(phrases.filled(step.here(), values)));
  }

  private Optional<Reported> valueOrAnything(String text) {
    return value(text).or(() -> matching(NAME, text).map(Reported::of));
  }
}
