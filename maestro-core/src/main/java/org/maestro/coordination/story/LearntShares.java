package org.maestro.coordination.story;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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

  private LearntShares(Map<String, List<String>> byMember) {
    this.byMember = byMember;
  }

  static LearntShares none() {
    return new LearntShares(new LinkedHashMap<>());
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

  /** A sentence on what the steps rest on, unless it was told. */
  Optional<String> news(List<Step> steps, Sentences sentences) {
    List<String> facts =
        steps.stream()
            .map(Step::member)
            .distinct()
            .flatMap(member -> Stream.ofNullable(byMember.remove(member)))
            .flatMap(List::stream)
            .map(sentences::fact)
            .limit(MOST_FACTS)
            .toList();
    return facts.isEmpty()
        ? Optional.empty()
        : Optional.of("Learnt from measurements before: " + String.join("; ", facts) + ".");
  }
}
