package org.maestro.launch;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.ontology.home.Home;
import org.maestro.sim.calibration.CameraCalibration;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Fits the fast model of a camera's detection to what its pictures show. */
@Command(
    name = "camera",
    description =
        "Tell in which light the pictures of a simulated camera show a thing, and the settings by"
            + " which the fast model of its detection comes nearest. It takes about ten seconds for"
            + " each place.")
final class CalibrateCameraCommand implements Callable<Integer> {
  private static final int MOST_PLACES = 1000;
  private static final String FROM_PIXELS = "world.camera.fromPixels";

  @Spec private CommandSpec spec;

  @Parameters(
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      description = "A home file, or a shipped home: bob, arena.")
  private String home;

  @Option(
      names = "--camera",
      paramLabel = "ID",
      description = "A camera that hangs in one place; without: the first one of the home.")
  private Optional<String> camera = Optional.empty();

  @Option(
      names = "--thing",
      paramLabel = "NAME",
      description = "What it is to find; without: the smallest that has a colour.")
  private Optional<String> thing = Optional.empty();

  @Option(
      names = "--scene",
      paramLabel = "S.ttl",
      completionCandidates = Shipped.Scenes.class,
      description = "Of which the sky counts, and where devices stand: a file, or a shipped scene.")
  private Optional<String> scene = Optional.empty();

  @Option(
      names = "--places",
      paramLabel = "N",
      defaultValue = "5",
      description = "How many places in view it is set down at; default ${DEFAULT-VALUE}.")
  private int places = 5;

  @Option(
      names = "--seed",
      paramLabel = "S",
      defaultValue = "1",
      description = "Of the places and of all noise; default ${DEFAULT-VALUE}.")
  private long seed = 1;

  @Option(
      names = "--set",
      paramLabel = "name=value",
      description = "Set something of the world, such as world.image.mostGain=1.")
  private Map<String, String> given = new LinkedHashMap<>();

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    if (places < 1 || places > MOST_PLACES) {
      throw CommandException.badInput(
          "There are 1 to %d places, not %d.".formatted(MOST_PLACES, places));
    }
    if (given.containsKey(FROM_PIXELS)) {
      throw CommandException.badInput(
          "Calibrated is the detection in pictures: leave %s away.".formatted(FROM_PIXELS));
    }
    Home loaded = Shipped.home(home);
    Scene truth =
        scene
            .or(() -> Shipped.usualScene(home))
            .map(name -> Shipped.scene(name, loaded))
            .orElseGet(() -> new Scene("bare", Map.of()));
    PhysicalParameters parameters = PhysicalParameters.standard().with(given);
    String eye = chosen(camera, CameraCalibration.cameras(loaded), "camera", "--camera");
    String wanted =
        chosen(thing, CameraCalibration.things(loaded), "thing with a colour", "--thing");
    CalibrationReport report;
    try (CameraCalibration calibration =
        new CameraCalibration(loaded, truth, eye, wanted, parameters, seed)) {
      report = new CalibrationReport(calibration.carriedOut(places));
    }
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(report.document());
    } else {
      report.print(out);
    }
    out.flush();
    return ExitCode.DONE;
  }

  /** The one that is named, or the first. */
  private static String chosen(
      Optional<String> named, List<String> all, String kind, String option) {
    if (all.isEmpty()) {
      throw CommandException.badInput("The home has no %s.".formatted(kind));
    }
    if (named.isPresent() && !all.contains(named.get())) {
      throw CommandException.badInput(
          "%s names a %s of the home, one of %s, not %s."
              .formatted(option, kind, String.join(", ", all), named.get()));
    }
    return named.orElse(all.get(0));
  }
}
