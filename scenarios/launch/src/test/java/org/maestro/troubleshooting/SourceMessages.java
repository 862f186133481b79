package org.maestro.troubleshooting;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.util.JavacTask;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Reads the sources of what people run, and collects the messages in them. */
final class SourceMessages {
  /** Measurements and experiments are for those who change the project. */
  private static final Predicate<Path> OF_USERS =
      file ->
          file.toString().contains("src/main/java")
              && Stream.of(
                      "scenarios/bench", "scenarios/experiment", "scenarios/fixtures", "target")
                  .map(Path::of)
                  .noneMatch(part -> file.toString().contains(part.toString()));

  private SourceMessages() {}

  static SortedSet<Message> of(Path root) {
    SortedSet<Message> messages = new TreeSet<>();
    units(root).forEach(unit -> messages.addAll(new UnitMessages(unit).found()));
    return messages;
  }

  /** What all of it is written in, file by file. */
  static List<CompilationUnitTree> units(Path root) {
    List<CompilationUnitTree> units = new ArrayList<>();
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null);
        Stream<Path> all = Files.walk(root)) {
      List<Path> sources =
          all.filter(file -> file.toString().endsWith(".java")).filter(OF_USERS).toList();
      JavacTask task =
          (JavacTask)
              compiler.getTask(
                  null,
                  files,
                  null,
                  List.of("-proc:none"),
                  null,
                  files.getJavaFileObjectsFromPaths(sources));
      task.parse().forEach(units::add);
    } catch (IOException e) {
      throw new UncheckedIOException("The sources cannot be read", e);
    }
    return units;
  }
}
