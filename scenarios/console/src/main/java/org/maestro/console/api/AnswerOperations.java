package org.maestro.console.api;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.maestro.console.access.Readership;
import org.maestro.console.api.Operation.Parameter;
import org.maestro.console.api.Operation.Request;
import org.maestro.console.documents.GivenAnswersDocument;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.PrivateWords;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/** The operations that tell what people have answered to scripts (ADE, 3.3; A45). */
public final class AnswerOperations {
  private static final Parameter SCRIPT =
      Parameter.perhaps("script", "Only what was answered to the script of that name.");

  private final Supplier<List<GivenAnswer>> answers;
  private final Supplier<Home> home;
  private final Readership readership;

  /**
   * @param answers oldest first
   * @param home as it is known at the time
   * @param readership who may read what is private
   */
  public AnswerOperations(
      Supplier<List<GivenAnswer>> answers, Supplier<Home> home, Readership readership) {
    this.answers = answers;
    this.home = home;
    this.readership = readership;
  }

  public List<Operation> operations() {
    return List.of(
        Operation.get(
                "/answers",
                "answers",
                "What people have answered to questions of scripts, oldest first.",
                "answers",
                request -> CompletableFuture.completedFuture(document(request)))
            .with(SCRIPT),
        Operation.csv(
                "/answers.csv",
                "answersAsCsv",
                "The same as comma-separated values, a record for each answer.",
                request ->
                    CompletableFuture.completedFuture(GivenAnswersDocument.csv(document(request))))
            .with(SCRIPT));
  }

  /** What a script that uses private words was answered is told as its story is. */
  private ObjectNode document(Request request) {
    Optional<String> script = request.perhaps("script");
    ReadingRights rights = readership.of(request.visit());
    PrivateWords words = PrivateWords.of(home.get());
    List<GivenAnswer> asked =
        answers.get().stream()
            .filter(answer -> script.isEmpty() || script.get().equals(answer.script()))
            .toList();
    List<GivenAnswer> told =
        asked.stream().filter(answer -> mayRead(rights, words, answer)).toList();
    return GivenAnswersDocument.of(told, asked.size() - told.size());
  }

  private static boolean mayRead(ReadingRights rights, PrivateWords words, GivenAnswer answer) {
    if (rights.areWhole()) {
      return true;
    }
    try {
      return rights.objection(words.usedFor(SlParser.formula(answer.goal()))).isEmpty();
    } catch (SlSyntaxException unreadable) {
      return false;
    }
  }
}
