package org.maestro.coordination.story;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.maestro.coordination.api.Sentences;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * What was learnt, before a goal, of what members' settings give, such as a lamp's to the light.
 * Each is told once, with the first plan that rests on it.
 */
final class LearntShares {
  private static final int MOST_FACTS = 6;

  private final Map<String, List<String>> byMember;
  private final Set<String> told = new HashSet<>();

  private LearntShares(Map<String, List<String>> byMember) {
    this.byMember = byMember;
  }

  static LearntShares none() {
    return new LearntShares(Map.of());
  }

  /**
   * Those among the facts.
   *
   * @param known in MAESTRO-SL
   */
  static LearntShares of(List<String> known, Vocabulary vocabulary) {
    Map<String, List<String>> byMember =
        known.stream()
            .filter(isOne(vocabulary))
            .collect(
                Collectors.groupingBy(
                    fact -> owner(fact, vocabulary), LinkedHashMap::new, Collectors.toList()));
    return new LearntShares(byMember);
  }

  static Predicate<String> isOne(Vocabulary vocabulary) {
    List<String> starts =
        vocabulary.predicates().values().stream()
            .filter(declared -> declared.shareOf().isPresent())
            .map(PredicateDeclaration::name)
            .map(name -> "(= (" + name + " ")
            .toList();
    return fact -> starts.stream().anyMatch(fact::startsWith);
  }

  /** Whose setting it is. */
  private static String owner(String fact, Vocabulary vocabulary) {
    Expression.Fluent share =
        (Expression.Fluent)
            ((Formula.Comparison) SlParser.formula(fact, vocabulary::isFluent)).left();
    PredicateDeclaration declared = vocabulary.predicate(share.name()).orElseThrow();
    List<Term> owners = declared.shareOf().orElseThrow().setting().arguments();
    for (int n = 0; n < declared.parameters().size(); n++) {
      if (owners.contains(new Term.Variable(declared.parameters().get(n).name()))
          && share.arguments().get(n) instanceof Term.Name name) {
        return name.text();
      }
    }
    return "";
  }

  /**
   * A sentence on what the steps rest on, unless it was told.
   *
   * @param isStill whether a fact is still known
   */
  Optional<String> news(List<Step> steps, Predicate<String> isStill, Sentences sentences) {
    List<String> facts = new ArrayList<>();
    for (Step step : steps) {
      for (String fact : byMember.getOrDefault(step.member(), List.of())) {
        if (facts.size() < MOST_FACTS && isStill.test(fact) && told.add(fact)) {
          facts.add(sentences.fact(fact));
        }
      }
    }
    return facts.isEmpty()
        ? Optional.empty()
        : Optional.of("Learnt from measurements before: " + String.join("; ", facts) + ".");
  }
}
