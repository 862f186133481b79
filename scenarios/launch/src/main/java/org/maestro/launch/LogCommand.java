package org.maestro.launch;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.maestro.storage.StorageFault;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * Tells where the log is, and puts the lines of several processes' logs in order (ADE, 3.3; A43).
 */
@Command(
    name = "log",
    description =
        "Tell where the log is, or merge the logs of several processes, each line after those that"
            + " it follows from.")
final class LogCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Option(
      names = "--merge",
      arity = "1..*",
      paramLabel = "FILE",
      description =
          "Print the lines of these logs in one order, whatever the clocks of their machines showed.")
  private List<Path> merged = new ArrayList<>();

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    if (merged.isEmpty()) {
      out.println(RuntimeDirectory.ofUser().log());
      return ExitCode.DONE;
    }
    MergedLog log = new MergedLog();
    for (Path file : merged) {
      add(log, file);
    }
    log.print(out::println);
    if (log.undated() > 0) {
      spec.commandLine()
          .getErr()
          .println(
              "Lines that are left out, as they have no time by which to order them: %d"
                  .formatted(log.undated()));
    }
    return ExitCode.DONE;
  }

  private void add(MergedLog log, Path file) {
    if (!Files.isRegularFile(file)) {
      throw CommandException.badInput(
          "There is no log %s; name files such as %s."
              .formatted(file, RuntimeDirectory.ofUser().log()));
    }
    try {
      log.add(source(file), file);
    } catch (IOException e) {
      throw CommandException.outside(
          "The log %s cannot be read (%s).".formatted(file, StorageFault.words(e)), e);
    }
  }

  /** Where several have one name, that of the directory says more. */
  private String source(Path file) {
    String name = String.valueOf(file.getFileName());
    boolean isShared =
        merged.stream()
            .filter(other -> String.valueOf(other.getFileName()).equals(name))
            .skip(1)
            .findAny()
            .isPresent();
    return isShared ? file.toString() : name;
  }
}
