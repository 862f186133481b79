package org.maestro.ontology.vocabulary;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;

/** The respects in which two declarations of one word differ, for who has to make them agree. */
final class WordDifference {
  private static final String NONE = "none";

  private WordDifference() {}

  /** Part of a sentence, such as {@code observable: no here, yes there}; "" when both are alike. */
  static String between(Vocabulary here, Vocabulary there, String name) {
    Map<String, String> ours = respects(here, name);
    Map<String, String> theirs = respects(there, name);
    Map<String, String> all = new LinkedHashMap<>(ours);
    theirs.forEach(all::putIfAbsent);
    return all.keySet().stream()
        .filter(respect -> !Objects.equals(ours.get(respect), theirs.get(respect)))
        .map(
            respect ->
                "%s: %s here, %s there"
                    .formatted(
                        respect,
                        ours.getOrDefault(respect, NONE),
                        theirs.getOrDefault(respect, NONE)))
        .collect(Collectors.joining("; "));
  }

  private static Map<String, String> respects(Vocabulary vocabulary, String name) {
    Map<String, String> respects = new LinkedHashMap<>();
    Optional.ofNullable(vocabulary.classes().get(name))
        .map(ClassDeclaration::unlabelled)
        .ifPresent(
            declared -> {
              respects.put("kind", "a class");
              respects.put("IRI", declared.iri());
              respects.put("under", declared.ancestors().stream().sorted().toList().toString());
            });
    vocabulary
        .predicate(name)
        .map(PredicateDeclaration::unlabelled)
        .ifPresent(declared -> predicate(declared, respects));
    if (vocabulary.features().containsKey(name)) {
      respects.put("kind", "a feature");
    }
    return respects;
  }

  private static void predicate(PredicateDeclaration declared, Map<String, String> respects) {
    respects.put("kind", declared.fluent() ? "a number" : "true or false");
    respects.put("IRI", declared.iri());
    respects.put("arguments", declared.form());
    respects.put("observable", yes(declared.observable()));
    respects.put("functional", yes(declared.functional()));
    respects.put("symmetric", yes(declared.symmetric()));
    respects.put("validFor", declared.validFor().map(Duration::toString).orElse(NONE));
    respects.put("derivedWhen", text(declared.derivedWhen()));
    respects.put("countedWhen", text(declared.countedWhen()));
    respects.put("observedWhen", text(declared.observedWhen()));
    respects.put("unit", declared.unit().orElse(NONE));
    respects.put(
        "least",
        declared.least().isPresent() ? String.valueOf(declared.least().getAsDouble()) : NONE);
    List<Object> others =
        List.of(
            declared.validForByClass(),
            declared.likelyWhen(),
            declared.computedBy(),
            declared.takenFrom(),
            declared.shareOf());
    respects.put("the rest", others.toString());
  }

  private static String yes(boolean is) {
    return is ? "yes" : "no";
  }

  private static String text(Optional<Formula> formula) {
    return formula.map(SlPrinter::print).orElse(NONE);
  }
}
