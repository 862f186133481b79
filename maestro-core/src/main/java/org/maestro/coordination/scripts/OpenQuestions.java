package org.maestro.coordination.scripts;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.Respondent;
import org.maestro.ontology.home.Home;

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
   * @param then told once why it is not taken; nothing when it is
   */
  void answer(
      String path,
      String part,
      String text,
      Respondent by,
      Home home,
      Consumer<Optional<AnswerRefusal>> then) {
    Question question = open.get(path);
    if (question == null) {
      then.accept(Optional.of(AnswerRefusal.notOpen(part)));
      return;
    }
    Answers answers = question.answers(home);
    answers
        .read(text)
        .ifPresentOrElse(
            answer -> {
              open.remove(path);
              question.answered().with(answer, by, () -> then.accept(Optional.empty()));
            },
            () ->
                then.accept(
                    Optional.of(
                        new AnswerRefusal(
                            "%s is not answered by \"%s\"; %s."
                                .formatted(part, text.strip(), answers.cure()),
                            true))));
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
