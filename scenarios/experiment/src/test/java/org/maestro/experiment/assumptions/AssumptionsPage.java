package org.maestro.experiment.assumptions;

import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.maestro.experiment.Experiment;
import org.maestro.experiment.Experiments;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Setting;
import org.maestro.sim.parameters.FaceData;
import org.maestro.sim.parameters.PhysicalSettings;
import org.maestro.sim.parameters.Quantity;

/** The page of all that the simulated world takes for granted, as the code says it now. */
final class AssumptionsPage {
  private static final List<Path> SOURCES =
      List.of(
          Path.of("../../device-sim/src/main/java/org/maestro/hal"),
          Path.of("../../device-sim/src/main/java/org/maestro/sim"),
          Path.of("../../device-sim/src/main/java/org/maestro/device"),
          Path.of("../assembly/src/main/java"),
          Path.of("src/main/java"));

  private final StringBuilder text = new StringBuilder();

  private AssumptionsPage() {}

  static String written() throws IOException {
    AssumptionsPage page = new AssumptionsPage();
    page.begin();
    page.physics();
    page.faces();
    page.experiments();
    page.inCode();
    return page.text.toString();
  }

  private void begin() {
    line("# What the simulated world takes for granted");
    line("");
    line(
        "Made of the code by `AssumptionsTest`, which also says when it is out of date. What a home"
            + " states of its devices (speed, payload, luminous intensity, views) is the home's and"
            + " stands before what is usual here: [the words for it](reference-homes.md).");
    line("");
  }

  private void physics() {
    line("## What can be set");
    line("");
    line(
        "`./maestro experiment … --set NAME=VALUE`, and `world` of a [scene](guide-scenes.md)."
            + " \"Acts in\" names the experiments in which another value changes what a run writes"
            + " (`SettingsActTest`, full run); in setups it does where a home has that hardware.");
    line("");
    row("Name", "Usual", "Unit", "What it is", "From", "Acts in");
    row("---", "---", "---", "---", "---", "---");
    Map<String, Quantity> quantities = PhysicalSettings.quantities();
    for (Setting setting : Physics.all()) {
      Quantity quantity = quantities.get(setting.name());
      row(
          "`" + setting.name() + "`",
          setting.usual(),
          quantity.unit(),
          quantity.meaning(),
          quantity.source(),
          actsIn(setting.name()));
    }
    line("");
  }

  private static String actsIn(String name) {
    List<String> names =
        Experiments.all().stream()
            .filter(
                experiment ->
                    experiment.settings().stream().anyMatch(setting -> setting.name().equals(name)))
            .map(Experiment::name)
            .toList();
    return names.size() == Experiments.all().size() ? "all" : String.join(", ", names);
  }

  private void faces() {
    line("## Faces");
    line("");
    row("Number", "Usual", "Unit", "What it is", "From");
    row("---", "---", "---", "---", "---");
    for (RecordComponent part : FaceData.class.getRecordComponents()) {
      Quantity quantity = part.getAnnotation(Quantity.class);
      row(
          part.getName(),
          String.valueOf(value(part)),
          quantity.unit(),
          quantity.meaning(),
          quantity.source());
    }
    line("");
  }

  private static Object value(RecordComponent part) {
    try {
      return part.getAccessor().invoke(FaceData.USUAL);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  private void experiments() {
    line("## What experiments add");
    line("");
    row("Name", "Usual", "What it is", "In");
    row("---", "---", "---", "---");
    Map<Setting, List<String>> added = new LinkedHashMap<>();
    for (Experiment experiment : Experiments.all()) {
      experiment.settings().stream()
          .filter(setting -> !PhysicalSettings.quantities().containsKey(setting.name()))
          .forEach(
              setting ->
                  added.computeIfAbsent(setting, any -> new ArrayList<>()).add(experiment.name()));
    }
    added.forEach(
        (setting, names) ->
            row(
                "`" + setting.name() + "`",
                setting.usual(),
                setting.meaning(),
                String.join(", ", names)));
    line("");
  }

  private void inCode() throws IOException {
    line("## What stands in the code");
    line("");
    line(
        "It cannot be set. Lengths are metres, times seconds, angles degrees, unless it says otherwise.");
    line("");
    row("Where", "Number", "What is assumed");
    row("---", "---", "---");
    for (StatedInCode stated :
        StatedInCode.in(SOURCES).stream()
            .filter(stated -> !stated.type().equals("PhysicalParameters"))
            .filter(stated -> !stated.type().equals("Quantity"))
            .toList()) {
      row(
          "`" + stated.type() + "`",
          stated.subject().isEmpty() ? "" : "`" + stated.subject() + "`",
          stated.sentences());
    }
  }

  private void row(String... cells) {
    line(
        Arrays.stream(cells)
            .map(cell -> cell.replace("|", "\\|"))
            .collect(Collectors.joining(" | ", "| ", " |")));
  }

  private void line(String line) {
    text.append(line).append('\n');
  }
}
