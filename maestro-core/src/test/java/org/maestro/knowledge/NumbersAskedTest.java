package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Truth;

/** Numbers are answered with their value, and what cannot be answered is refused. */
class NumbersAskedTest {
  private final Home home =
      new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
  private final CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock());

  @AfterEach
  void close() {
    knowledge.close();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(= (level lamp-b1) ?n) | n=0.4",
        "(= ?n (level lamp-b1)) | n=0.4",
        "(level lamp-b1) | value=0.4",
        "(= (* 2 (level lamp-b1)) ?n) | n=0.8",
        "(and (= (level lamp-b1) ?n) (= ?more (+ ?n 1))) | more=1.4 n=0.4",
        "(and (= (level ?l) ?n) (> ?n 0.5)) | l=lamp-b2 n=1",
        "(and (= (level ?l) ?n) (= (level lamp-b1) ?n)) | l=lamp-b1 n=0.4",
        "(= (level lamp-b1) 0.4) | -",
        "(= (level lamp-b1) 0.5) | none",
        "(= (illuminance zone-a) ?n) | none",
        "(or (in rose zone-b) (= (illuminance zone-a) ?n)) | -"
      })
  void answersWithValues(String question, String bindings) {
    knowledge.state(
        new Source(Source.Kind.STATED, "lamp-b1"),
        List.of("(= (level lamp-b1) 0.4)", "(= (level lamp-b2) 1)", "(in rose zone-b)"));

    List<Map<String, org.maestro.sl.Term>> answers =
        new Question(knowledge.snapshot()).queryRef(read(question));

    assertThat(answers).hasSize(bindings.equals("none") ? 0 : 1);
    answers.forEach(
        answer ->
            assertThat(
                    answer.entrySet().stream()
                        .map(e -> e.getKey() + "=" + SlPrinter.print(e.getValue()))
                        .sorted()
                        .collect(Collectors.joining(" ")))
                .isEqualTo(bindings.replace("-", "").isEmpty() ? "" : bindings));
  }

  @Test
  void whatNobodyMeasuredIsUnknownAndNotFalse() {
    Question question = new Question(knowledge.snapshot());

    assertThat(question.queryIf(read("(= (illuminance zone-a) ?n)"))).isEqualTo(Truth.UNKNOWN);
    assertThat(question.queryIf(read("(unknown (illuminance zone-a))"))).isEqualTo(Truth.TRUE);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "(>= (level lamp-b1) ?n)",
        "(exists (?n) (= (level lamp-b1) ?n))",
        "(= (level lamp-b1) (+ ?n 1))",
        "(keep (in Cup zone-a))",
        "(in Cup)",
        "(in zone-b Cup)",
        "(in \"Cup\" ?where)",
        "(level)",
        "(foo ?x)"
      })
  void refusesWhatHasNoAnswer(String question) {
    assertThatThrownBy(() -> read(question))
        .isInstanceOf(KnowledgeException.class)
        .hasMessageEndingWith(".");
  }

  @Test
  void refusesThePastOfWhatNobodyKnows() {
    assertThatThrownBy(() -> new QuestionReader(home).fact("(in Cup 3)"))
        .isInstanceOf(KnowledgeException.class);
    assertThat(new QuestionReader(home).fact("(= (level lamp-b1) 1)")).isNotEmpty();
  }

  private Formula read(String question) {
    return new QuestionReader(home).question(SlParser.formula(question));
  }
}
