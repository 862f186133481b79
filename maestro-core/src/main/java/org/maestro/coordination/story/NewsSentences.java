package org.maestro.coordination.story;

import java.util.List;
import java.util.stream.Collectors;
import org.maestro.coordination.api.Sentences;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** Puts into words what has come to be known, reports and expectations told apart. */
public final class NewsSentences {
  private static final int MOST_FACTS = 6;

  private final Vocabulary vocabulary;

  NewsSentences(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
  }

  /** What a member reports of a step that is done, and what is expected of the step. */
  String report(KnowledgeBase.Change change) {
    String reported = change.reported().isEmpty() ? "done" : facts(change.reported());
    return change.expected().isEmpty()
        ? reported
        : reported + "; expected so: " + facts(change.expected());
  }

  /** What has changed. */
  String all(KnowledgeBase.Change change) {
    if (change.expected().isEmpty()) {
      return facts(change.facts());
    }
    String expected = "it is expected: " + facts(change.expected());
    return change.reported().isEmpty() ? expected : facts(change.reported()) + ", and " + expected;
  }

  /** What is so now says most; what is not so comes second, what was lost last. */
  String facts(List<String> facts) {
    List<Formula> all =
        facts.stream().map(fact -> SlParser.formula(fact, vocabulary::isFluent)).toList();
    List<Formula> telling = all.stream().filter(NewsSentences::isSo).toList();
    if (telling.isEmpty()) {
      telling = all.stream().filter(Formula.Not.class::isInstance).toList();
    }
    if (telling.isEmpty()) {
      telling = all;
    }
    Sentences sentences = new Sentences(vocabulary);
    int more = telling.size() - MOST_FACTS;
    return telling.stream().limit(MOST_FACTS).map(sentences::fact).collect(Collectors.joining(", "))
        + (more > 0 ? " and " + more + " more" : "");
  }

  private static boolean isSo(Formula formula) {
    return formula instanceof Formula.Atom || formula instanceof Formula.Comparison;
  }
}
