package org.maestro.launch;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Answers a question of a script. */
@Command(
    name = "answer",
    description = "Answer a question that a script has asked; ./maestro goals shows who waits.")
final class AnswerCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(
      index = "0",
      paramLabel = "QUESTION",
      description = "The part of the script that asks, such as G1.2.")
  private String question;

  @Parameters(
      index = "1..*",
      arity = "1..*",
      paramLabel = "ANSWER",
      description =
          "Some words, a number, yes or no, the name or label of a thing, or what can be chosen, or"
              + " its place among that.")
  private List<String> words;

  @Option(
      names = "--as",
      paramLabel = "PERSON",
      description = "The person of the home whose answer it is; usually who was asked.")
  private Optional<String> person = Optional.empty();

  @Override
  public Integer call() {
    try (AskedPlatform asked = platform.ask()) {
      asked.answer(questions -> questions.answer(question, String.join(" ", words), person));
      spec.commandLine().getOut().println(question + " is answered.");
      return ExitCode.DONE;
    }
  }
}
