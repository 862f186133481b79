package org.maestro.launch;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.maestro.experiment.Comparison;
import org.maestro.experiment.Experiment;
import org.maestro.experiment.Experiments;
import org.maestro.experiment.Wish;
import org.maestro.ontology.home.Home;
import picocli.CommandLine.Option;

/** The homes that are to be compared, with their scenes, and the goals that are stated in each. */
final class SetUpOptions {
  @Option(
      names = "--home",
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      description = "A home to compare, a file or a shipped one; two or more times (setups).")
  private List<String> homes = new ArrayList<>();

  @Option(
      names = "--scene",
      paramLabel = "S.ttl",
      completionCandidates = Shipped.Scenes.class,
      description =
          "What is true in all of the homes, or, as often as --home, in each of them (setups).")
  private List<String> scenes = new ArrayList<>();

  @Option(
      names = "--goal",
      paramLabel = "GOAL",
      description = "What is wanted there; several are stated one after the other (setups).")
  private List<String> goals = new ArrayList<>();

  @Option(
      names = "--goals",
      paramLabel = "FILE",
      description =
          "The same in a file, a goal a line; a number in front is the second of the evening at"
              + " which it is stated (setups).")
  private Optional<String> file = Optional.empty();

  /** The experiment, with the homes that were named. */
  Experiment of(Experiment experiment) {
    if (homes.isEmpty() && scenes.isEmpty() && goals.isEmpty() && file.isEmpty()) {
      return experiment;
    }
    if (!Experiments.compares(experiment)) {
      throw CommandException.badInput(
          "--home, --scene, --goal and --goals say which set-ups are compared; they go with ./maestro experiment setups, not with %s."
              .formatted(experiment.name()));
    }
    return Experiments.comparing(comparison());
  }

  private Comparison comparison() {
    if (scenes.isEmpty() || scenes.size() > 1 && scenes.size() != homes.size()) {
      throw CommandException.badInput(
          "%d homes are to be compared, and %d scenes say what is true there; give one --scene for all, or one for each."
              .formatted(homes.size(), scenes.size()));
    }
    List<Home> loaded = homes.stream().map(Shipped::home).toList();
    List<String> names = names();
    List<Comparison.SetUp> setUps =
        IntStream.range(0, loaded.size())
            .mapToObj(
                i ->
                    new Comparison.SetUp(
                        names.get(i),
                        loaded.get(i),
                        scenes.size() == 1
                            ? Shipped.scene(scenes.get(0), loaded.get(i), loaded)
                            : Shipped.scene(scenes.get(i), loaded.get(i))))
            .toList();
    return new Comparison(setUps, wishes(), given());
  }

  private List<Wish> wishes() {
    Stream<Wish> inFile = file.stream().flatMap(path -> Wish.read(path, text(path)).stream());
    return Stream.concat(goals.stream().map(Wish::of), inFile).toList();
  }

  private static String text(String path) {
    Path goals = Path.of(path);
    if (!Files.isRegularFile(goals)) {
      throw CommandException.badInput(
          "There is no goals file %s; give the path of a text file with a goal a line."
              .formatted(path));
    }
    return Shipped.read(goals);
  }

  /** Files of one name are told apart by their directories, and the same file by its number. */
  private List<String> names() {
    List<String> shortNames =
        homes.stream().map(home -> String.valueOf(Path.of(home).getFileName())).toList();
    boolean isClear = Set.copyOf(shortNames).size() == shortNames.size();
    Set<String> names = new LinkedHashSet<>();
    for (String name : isClear ? shortNames : homes) {
      String unique = name;
      for (int number = 2; !names.add(unique); number++) {
        unique = "%s (%d)".formatted(name, number);
      }
    }
    return List.copyOf(names);
  }

  private String given() {
    StringBuilder words = new StringBuilder();
    homes.forEach(home -> words.append(" --home ").append(home));
    scenes.forEach(scene -> words.append(" --scene ").append(scene));
    goals.forEach(goal -> words.append(" --goal \"").append(goal).append('"'));
    file.ifPresent(path -> words.append(" --goals ").append(path));
    return words.toString();
  }
}
