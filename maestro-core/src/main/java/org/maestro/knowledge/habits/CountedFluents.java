package org.maestro.knowledge.habits;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;

/** What the home's words have counted. Any thread may ask. */
final class CountedFluents {
  private final KnowledgeBase knowledge;
  private volatile @Nullable Counted last;

  /** The same of one vocabulary, and the words on which that depends. */
  private record Counted(
      Vocabulary vocabulary, List<PredicateDeclaration> fluents, Set<String> words) {}

  CountedFluents(KnowledgeBase knowledge) {
    this.knowledge = knowledge;
  }

  List<PredicateDeclaration> all() {
    return now().fluents();
  }

  /** Whether one of the facts is such that a count may depend on it. */
  boolean speakOf(Collection<String> facts) {
    Counted now = now();
    return !now.fluents().isEmpty()
        && facts.stream().anyMatch(fact -> now.words().contains(word(fact)));
  }

  private static String word(String fact) {
    return fact.replaceFirst("^\\((?:=\\s*\\()?", "").split("[\\s)]", 2)[0];
  }

  @SuppressWarnings("ReferenceEquality") // Another vocabulary is another object.
  private Counted now() {
    Vocabulary vocabulary = knowledge.home().vocabulary();
    Counted known = last;
    if (known == null || known.vocabulary() != vocabulary) {
      known = counted(vocabulary);
      last = known;
    }
    return known;
  }

  private static Counted counted(Vocabulary vocabulary) {
    List<PredicateDeclaration> fluents =
        vocabulary.predicates().values().stream()
            .filter(declared -> declared.countedWhen().isPresent())
            .toList();
    Set<String> words = new HashSet<>();
    fluents.forEach(fluent -> fluent.countedWhen().ifPresent(f -> add(f, vocabulary, words)));
    return new Counted(vocabulary, fluents, words);
  }

  private static void add(Formula formula, Vocabulary vocabulary, Set<String> words) {
    Leaves.of(
        formula,
        atom -> add(atom.predicate(), vocabulary, words),
        fluent -> add(fluent.name(), vocabulary, words));
  }

  private static void add(String word, Vocabulary vocabulary, Set<String> words) {
    if (words.add(word)) {
      vocabulary
          .predicate(word)
          .ifPresent(
              declared ->
                  Stream.of(declared.derivedWhen(), declared.observedWhen())
                      .flatMap(Optional::stream)
                      .forEach(rule -> add(rule, vocabulary, words)));
    }
  }
}
