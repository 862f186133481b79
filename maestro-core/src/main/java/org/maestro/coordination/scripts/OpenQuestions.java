package org.maestro.coordination.scripts;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Term;

/** The questions of one script that nobody has answered yet, by their parts' paths. */
final class OpenQuestions {
  private final Map<String, Question> open = new LinkedHashMap<>();

  void ask(String path, Question question) {
    open.put(path, question);
  }

  void withdraw(String path) {
    open.remove(path);
  }

  boolean isOpen(String path) {
    return open.containsKey(path);
  }

  /**
   * Takes an answer that would do; one that would not leaves the question open.
   *
   * @return why it is not taken; empty when it is
   */
  Optional<AnswerRefusal> answer(String path, String part, String text, String who, Home home) {
    Question question = open.get(path);
    if (question == null) {
      return Optional.of(AnswerRefusal.notOpen(part));
    }
    Answers answers = new Answers(question.type(), home);
    Optional<Term> answer = answers.read(text);
    if (answer.isEmpty()) {
      return Optional.of(
          new AnswerRefusal(
              "%s is not answered by \"%s\"; %s.".formatted(part, text.strip(), answers.cure()),
              true));
    }
    open.remove(path);
    question.answered().accept(answer.get(), who);
    return Optional.empty();
  }

  /** What is waited for, for the list of goals. */
  List<String> inWords(Home home) {
    return open.entrySet().stream()
        .map(
            entry ->
                "step %s: for an answer of %s to \"%s\""
                    .formatted(
                        entry.getKey(),
                        entry.getValue().who(),
                        Sentence.of(entry.getValue().words(), home)))
        .toList();
  }
}
