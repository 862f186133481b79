package org.maestro.console.chat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.maestro.dialogue.Utterance;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.vocabulary.PredicateDeclaration;

/** The words of a home by which people call its things and what can be so. */
final class HomeWords {
  private static final int MOST_WORDS = 8;
  private static final Set<String> EMPTY_WORDS =
      Set.of("the", "a", "an", "is", "are", "be", "of", "please", "lux", "and");

  /** Numbers are meant so anyway. */
  private static final Pattern AT_LEAST = Pattern.compile("(?i)\\bat least\\b");

  private final Home home;
  private final Map<String, List<Individual>> things = new TreeMap<>();
  private final Map<String, PredicateDeclaration> predicates = new TreeMap<>();

  /** A part of a sentence that has a meaning. */
  sealed interface Part {
    record Predicate(PredicateDeclaration declaration) implements Part {}

    /**
     * @param candidates that are called so, at least one
     */
    record Things(String said, List<Individual> candidates) implements Part {}

    record Amount(String number) implements Part {}

    record Unknown(String word) implements Part {}
  }

  HomeWords(Home home) {
    this.home = home;
    for (Individual one : home.individuals().values()) {
      call(one.name(), one);
      call(one.label(), one);
      call(withoutArticle(one.label()), one);
    }
    home.vocabulary()
        .predicates()
        .values()
        .forEach(
            predicate -> {
              predicates.put(small(predicate.label()), predicate);
              predicates.put(small(predicate.name()), predicate);
            });
  }

  private void call(String name, Individual one) {
    List<Individual> called = things.computeIfAbsent(small(name), key -> new ArrayList<>());
    if (!called.contains(one)) {
      called.add(one);
    }
  }

  private static String small(String text) {
    return text.toLowerCase(Locale.ROOT).strip();
  }

  private static String withoutArticle(String label) {
    return label.toLowerCase(Locale.ROOT).startsWith("the ") ? label.substring(4) : label;
  }

  /** The parts of a sentence; longer names go before shorter ones. */
  List<Part> parts(String sentence, Utterance context) {
    List<String> words =
        Arrays.stream(AT_LEAST.matcher(sentence).replaceAll(" ").strip().split("\\s+"))
            .map(word -> word.replaceAll("[.,;!]+$", ""))
            .filter(word -> !word.isEmpty())
            .toList();
    List<Part> parts = new ArrayList<>();
    int at = 0;
    while (at < words.size()) {
      int taken = 0;
      for (int many = Math.min(MOST_WORDS, words.size() - at); many > 0 && taken == 0; many--) {
        Optional<Part> part = named(String.join(" ", words.subList(at, at + many)), context);
        if (part.isPresent()) {
          parts.add(part.get());
          taken = many;
        }
      }
      if (taken == 0 && !EMPTY_WORDS.contains(small(words.get(at)))) {
        parts.add(plain(words.get(at)));
      }
      at += Math.max(1, taken);
    }
    return parts;
  }

  private static Part plain(String word) {
    return word.matches("-?\\d+(\\.\\d+)?") ? new Part.Amount(word) : new Part.Unknown(word);
  }

  private Optional<Part> named(String phrase, Utterance context) {
    String name = small(phrase);
    if (name.equals("me")) {
      return things(phrase, context.person());
    }
    if (name.equals("here")) {
      return things(phrase, context.room());
    }
    if (things.containsKey(name)) {
      return Optional.of(new Part.Things(phrase, things.get(name)));
    }
    return Optional.ofNullable(predicates.get(name)).map(Part.Predicate::new);
  }

  /** A thing, and all that are called as it is: a room's zone has the room's name. */
  private Optional<Part> things(String said, String name) {
    return Optional.ofNullable(home.individuals().get(name))
        .map(
            one -> {
              Set<Individual> all = new LinkedHashSet<>(List.of(one));
              all.addAll(things.getOrDefault(small(one.label()), List.of()));
              return new Part.Things(said, List.copyOf(all));
            });
  }

  /** The name of whoever of these fits the class; of the first where nobody does. */
  static String fitting(Part.Things named, Optional<String> className) {
    return named.candidates().stream()
        .filter(one -> className.map(one.classes()::contains).orElse(true))
        .findFirst()
        .orElse(named.candidates().get(0))
        .name();
  }

  /** Something that can be said in this home, as the end of a sentence; "" when it has no items. */
  String example() {
    return home.individuals().values().stream()
        .filter(one -> one.classes().contains("Item"))
        .findFirst()
        .map(one -> ", such as: %s next to me".formatted(one.label()))
        .orElse("");
  }

  /** The names of all things of a class. */
  List<String> ofClass(String className) {
    return home.individuals().values().stream()
        .filter(one -> className.isEmpty() || one.classes().contains(className))
        .map(Individual::name)
        .toList();
  }

  /** The known name that is next to an unknown word. */
  Optional<String> near(String word) {
    return Nearest.to(
        word,
        Stream.concat(
                home.vocabulary().predicates().keySet().stream(),
                home.individuals().keySet().stream())
            .toList());
  }

  /** What can be so of so many things, what devices see first. */
  List<PredicateDeclaration> takingThings(List<Part.Things> named) {
    return home.vocabulary().predicates().values().stream()
        .filter(one -> !one.fluent() && one.observable())
        .filter(one -> one.parameters().size() == named.size())
        .filter(one -> fits(one, named))
        .toList();
  }

  private static boolean fits(PredicateDeclaration predicate, List<Part.Things> named) {
    boolean fits = true;
    for (int i = 0; i < named.size(); i++) {
      Optional<String> wanted = predicate.parameters().get(i).className();
      fits &=
          named.get(i).candidates().stream()
              .anyMatch(one -> wanted.map(one.classes()::contains).orElse(true));
    }
    return fits;
  }
}
