package org.maestro.launch;

import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Has a script of the home carried out: the goal that is stated by its name. */
@Command(
    name = "run-script",
    description =
        "Have a running platform carry out a script of its home, and follow it live;"
            + " ./maestro scripts lists them.")
final class RunScriptCommand extends StatedGoal {
  @Parameters(index = "0", paramLabel = "NAME", description = "The script's name.")
  private String name;

  @Parameters(
      index = "1..*",
      arity = "0..*",
      paramLabel = "ARG",
      description = "What its parameters stand for, in their order: things, numbers, texts.")
  private List<String> values = new ArrayList<>();

  @Override
  String goal() {
    return values.isEmpty() ? "(" + name + ")" : "(" + name + " " + String.join(" ", values) + ")";
  }

  @Override
  boolean wasStated() {
    return false;
  }
}
