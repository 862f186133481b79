package org.maestro.coordination.story;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.facts.Confirmation;
import org.maestro.knowledge.api.Belief;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.SlParser;

/**
 * Sentences about witnesses: who has to look before a goal is called reached, who cannot, and who
 * says otherwise.
 */
record WitnessSentences(Vocabulary vocabulary, Instant now) {

  /** What is to be seen before. */
  String wanted(Confirmation needed) {
    List<String> wanted = new ArrayList<>();
    if (!needed.things().isEmpty()) {
      wanted.add("it is to be seen: " + String.join(", ", needed.things()));
    }
    if (!needed.facts().isEmpty()) {
      wanted.add(
          "it is to be looked at whether "
              + needed.facts().stream().map(sentences()::fact).collect(Collectors.joining(", ")));
    }
    if (!needed.numbers().isEmpty()) {
      wanted.add(
          "it is to be measured: "
              + needed.numbers().stream()
                  .map(sentences()::quantity)
                  .collect(Collectors.joining(", ")));
    }
    return "It should be so now; " + String.join("; ", wanted) + ".";
  }

  /** Why it is not certain. */
  String missing(Confirmation needed) {
    if (needed.isOnlyDisputed()) {
      return "It is so by the surer source; it is not certain: "
          + told(needed.objections(), " has said since: ")
          + ".";
    }
    if (needed.reporters().isEmpty() && needed.oldest().isPresent()) {
      return "It was so when it was observed %d s ago; nobody can observe it again."
          .formatted(Duration.between(needed.oldest().get(), now).toSeconds());
    }
    return needed.reporters().isEmpty()
        ? "It is so, as far as is known; nobody can confirm it."
        : "It is done, as far as %s; nobody can confirm it."
            .formatted(Sentences.say(needed.reporters()));
  }

  /** Who has looked, and does not agree with who did it. */
  String against(Confirmation needed) {
    return "It cannot be said to be so: %s; but %s."
        .formatted(
            needed.reporters().isEmpty()
                ? "it was done"
                : Sentences.say(needed.reporters()) + " so",
            told(needed.denials().isEmpty() ? needed.missed() : needed.denials(), " tells: "));
  }

  private String told(List<Belief> beliefs, String verb) {
    return beliefs.stream()
        .map(
            said ->
                said.source().agent()
                    + verb
                    + sentences().fact(SlParser.formula(said.fact(), vocabulary::isFluent)))
        .collect(Collectors.joining("; "));
  }

  private Sentences sentences() {
    return new Sentences(vocabulary);
  }
}
