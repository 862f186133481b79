package org.maestro.experiment;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.maestro.experiment.drawing.Bars;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Ink;
import org.maestro.experiment.drawing.TimeChart;
import org.maestro.experiment.measuring.Spread;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.page.Page;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Setting;
import org.maestro.experiment.setting.Settings;

/** The paper's section 5.1: detection in the dark, and after an agent has seen to the light. */
final class Illumination implements Experiment {
  static final double THRESHOLD = 72;
  static final String DARKEST = "world.dark.least";
  static final String DARK_MOST = "world.dark.most";
  static final String FALLEN = "world.dusk";
  private static final String FROM_PIXELS = "world.camera.fromPixels";
  private static final String GOAL = "(keep (>= (illuminance zone-2) 72))";
  private static final String LAMP_SECONDS = "world.lamp.transitionSeconds";

  /**
   * Nobody moves, a camera is watched of which frames alone are counted, and there are no windows.
   */
  private static final String[] IDLE = {
    "world.shutters",
    "world.camera.minimumLux",
    "world.camera.noise",
    "world.camera.lightError",
    "world.camera.noticesGlare",
    "world.facade.",
    "world.base.",
    "world.scanner.",
    "world.wheels.",
    "world.arm.",
    "world.gripper.",
    "world.battery.",
    "world.drives."
  };

  @Override
  public String name() {
    return "illumination";
  }

  @Override
  public String purpose() {
    return "detection rate and light over time, in the dark and after lamps are raised (figures 5 to 8)";
  }

  @Override
  public int usualRuns() {
    return 5;
  }

  @Override
  public List<Setting> settings() {
    List<Setting> settings = new ArrayList<>();
    settings.add(
        Setting.number(DARKEST, 16, 0, 10_000, "least light in the dark case, lux; paper 5.1"));
    settings.add(
        Setting.number(DARK_MOST, 19, 0, 10_000, "most light in the dark case, lux; paper 5.1"));
    settings.add(
        Setting.number(
            FALLEN, 40, 0, 10_000, "light that is left after it has fallen, lux; paper 5.1"));
    settings.addAll(Physics.settingsWithout(IDLE));
    return settings;
  }

  /** The runs of one seed, in the dark and with the light that comes back. */
  private record Pair(LightRun dark, LightRun recovery) {}

  @Override
  public Course<?> begin(Request request) {
    return new Course<>(
        request.runs(),
        run ->
            new Pair(
                run(request, run, LightRun.Case.DARK), run(request, run, LightRun.Case.RECOVERY)),
        pair ->
            pair.recovery().recoverySeconds().isPresent()
                ? String.format(
                    Locale.ROOT,
                    "light was back after %.1f s",
                    pair.recovery().recoverySeconds().getAsDouble())
                : "light did not come back",
        pairs ->
            findings(
                request,
                pairs.stream().map(Pair::dark).toList(),
                pairs.stream().map(Pair::recovery).toList()));
  }

  private static LightRun run(Request request, int run, LightRun.Case way) {
    return LightRun.carryOut(run, request.seedOf(run), way, request.settings());
  }

  private static Findings findings(Request request, List<LightRun> dark, List<LightRun> recovery) {
    Map<String, Table> tables = new LinkedHashMap<>();
    tables.put("runs", runs(recovery, request.settings().number(LAMP_SECONDS)));
    tables.put("samples", samples(dark, recovery));
    tables.put("story", story(recovery));
    PixelCurve pixels = PixelCurve.measured(Physics.of(request.settings()), request.seedOf(1));
    tables.put("pixels", pixels.table());
    List<Figure> figures = new ArrayList<>(figures(dark.get(0), recovery.get(0)));
    figures.add(pixels.figure());
    return new Findings(
        "illumination",
        List.of(
            new Findings.Result("runs of each case", dark.size(), ""),
            new Findings.Result(
                "detection rate in the dark", 100 * LightRun.rate(dark, sample -> true), "%"),
            new Findings.Result(
                "detection rate below the threshold, light fallen",
                100 * LightRun.rate(recovery, sample -> sample.lux() < THRESHOLD),
                "%"),
            new Findings.Result(
                "detection rate above the threshold",
                100 * LightRun.rate(recovery, sample -> sample.lux() >= THRESHOLD),
                "%"),
            new Findings.Result("light was back after, mean", back(recovery).mean(), "s"),
            new Findings.Result(
                "light in which half of the pictures show the object", pixels.halfLux(), "lux")),
        tables,
        figures,
        page(request, dark, recovery, figures, pixels));
  }

  private static Spread back(List<LightRun> recovery) {
    return Spread.of(
        recovery.stream().flatMapToDouble(run -> run.recoverySeconds().stream()).toArray());
  }

  private static Table runs(List<LightRun> recovery, double lampSeconds) {
    Table table =
        new Table(
            "run", "seed", "goal", "success", "duration_s", "lower_bound_s", "replans", "failure");
    for (LightRun run : recovery) {
      boolean back = run.recoverySeconds().isPresent();
      table.add(
          run.number(),
          run.seed(),
          GOAL,
          back,
          run.recoverySeconds().orElse(Double.NaN),
          lampSeconds,
          Math.max(0, run.plans().size() - 1),
          back ? "" : "Within 20 s the light at the sensor did not reach 72 lux again.");
    }
    return table;
  }

  private static Table samples(List<LightRun> dark, List<LightRun> recovery) {
    Table table =
        new Table("run", "case", "t_s", "lux_sensor", "lux_object", "frames", "detections", "rate");
    for (List<LightRun> runs : List.of(dark, recovery)) {
      for (LightRun run : runs) {
        for (LightRun.Sample sample : run.samples()) {
          table.add(
              run.number(),
              run.kind().name().toLowerCase(Locale.ROOT),
              sample.second(),
              sample.lux(),
              sample.objectLux(),
              sample.frames(),
              sample.detections(),
              sample.rate());
        }
      }
    }
    return table;
  }

  private static Table story(List<LightRun> recovery) {
    Table table = new Table("run", "t_s", "goal", "kind", "text");
    for (LightRun run : recovery) {
      run.story()
          .forEach(
              entry ->
                  table.add(
                      run.number(),
                      entry.at().toMillis() / 1e3,
                      entry.goalId(),
                      entry.kind(),
                      entry.text()));
    }
    return table;
  }

  private static List<Figure> figures(LightRun dark, LightRun recovery) {
    return List.of(
        Figure.of(
            "camera-dark",
            "What camera 2 shows in the dark case (compare figure 5). The image is noisy: the exposure is at its limit, and the gain makes up for it.",
            dark.photo()),
        Figure.of(
            "rate-dark",
            "Light at the sensor and detection rate of the green object, five times a second, in the dark case (compare figure 6).",
            chart("In the dark: the green object is not detected", dark, List.of())),
        Figure.of(
            "camera-lit",
            "What camera 2 shows after the agent has raised the light (compare figure 7).",
            recovery.photo()),
        Figure.of(
            "rate-recovery",
            "The same when the light falls and the illumination agent raises it again (compare figure 8). The dashed line is the camera's threshold.",
            chart(
                "The illumination agent raises the light",
                recovery,
                List.of(new TimeChart.Event(LightRun.FALL, "light falls")))));
  }

  private static BufferedImage chart(String title, LightRun run, List<TimeChart.Event> events) {
    return TimeChart.draw(
        title,
        "light (lux)",
        List.of(
            new TimeChart.Series(
                "light at the sensor",
                Ink.BLUE,
                run.samples().stream()
                    .map(sample -> new double[] {sample.second(), sample.lux()})
                    .toList())),
        "frames that show the object (%)",
        new TimeChart.Series(
            "detection rate, green object",
            Ink.RED,
            run.samples().stream()
                .map(sample -> new double[] {sample.second(), 100 * sample.rate()})
                .toList()),
        new Bars.Level(THRESHOLD, "camera's threshold, 72 lux", Ink.BLACK),
        events);
  }

  private static Page page(
      Request request,
      List<LightRun> dark,
      List<LightRun> recovery,
      List<Figure> figures,
      PixelCurve pixels) {
    Page page =
        new Page(
            "Illumination",
            "The paper's section 5.1: colour-based detection fails in the dark; the deliberation of the illumination agent yields a plan that raises the light, and detection is stable again.",
            request.command("illumination"));
    page.heading("Paper and measurement")
        .comparison(rows(dark, recovery, request.settings(), pixels));
    page.heading("Figures");
    figures.forEach(page::figure);
    page.heading("What the illumination agent found and planned, run 1")
        .list(recovery.get(0).plans());
    page.heading("What was assumed")
        .list(
            List.of(
                request.settings().value(Physics.setting(FROM_PIXELS)).equals("true")
                    ? "The object is found in pictures of the camera, by colour and size (world.camera.fromPixels). In which light is therefore a finding: it follows from the noise of a sensor as its data sheet states it, and from how large the object is in the picture. That a plan raises the light to 72 lux follows from the goal."
                    : "A frame shows the object with a chance that is a logistic function of the light upon it, half at world.camera.halfLux; its place was assumed a little under the paper's threshold of 72 lux, so that detection is nearly certain from there on. That rate and threshold agree is therefore an assumption, not a finding; that the agent notices, plans and recovers is the finding. With world.camera.fromPixels=true the object is found in pictures instead.",
                pixels.meaning(),
                "In the dark case the rest light swings between 16 and 19 lux, which are the paper's extremes.",
                "In the other case the light falls at once from 80 to 40 lux after 10 s, as when a blind is drawn.",
                "The rate is that of 6 frames, a fifth of a second of the camera."));
    page.heading("What differs from the paper, and why")
        .list(
            List.of(
                "The paper shows a scatter of one session; here the first of several runs is drawn, and all are in samples.csv.",
                "Lamps have four levels here (0, 0.25, 0.5, 1); which level is reached above 72 lux follows from them and from what lamps cost, not from the paper's 75 lux."));
    return page.settings(request.settings());
  }

  private static List<Page.Row> rows(
      List<LightRun> dark, List<LightRun> recovery, Settings settings, PixelCurve pixels) {
    double[] lux =
        dark.stream()
            .flatMap(run -> run.samples().stream())
            .mapToDouble(LightRun.Sample::lux)
            .toArray();
    Spread inTheDark = Spread.of(lux);
    double[] after =
        recovery.stream()
            .mapToDouble(run -> run.samples().get(run.samples().size() - 1).lux())
            .toArray();
    Spread raised = Spread.of(after);
    Spread back = back(recovery);
    return List.of(
        new Page.Row(
            "light in the dark case",
            "about 16 to 19 lux",
            String.format(Locale.ROOT, "%.1f to %.1f lux", inTheDark.least(), inTheDark.greatest()),
            "set so, after the paper"),
        new Page.Row(
            "detection in the dark case",
            "the green object is not detected",
            percent(LightRun.rate(dark, sample -> true)),
            "of all frames"),
        new Page.Row(
            "light raised",
            "from about 40 to about 75 lux",
            String.format(
                Locale.ROOT,
                "to %.1f lux in the mean (%.1f to %.1f)",
                raised.mean(),
                raised.least(),
                raised.greatest()),
            "by the agent's own plan, see below"),
        new Page.Row(
            "threshold", "about 72 lux", "72 lux", "the camera's specification in the home"),
        new Page.Row(
            "light in which pictures show the object",
            "from about 72 lux on",
            pixels.range(),
            "found in pictures by colour and size, see the last figure"),
        new Page.Row(
            "detection below and above it",
            "prevented; stabilised",
            percent(LightRun.rate(recovery, sample -> sample.lux() < THRESHOLD))
                + "; "
                + percent(LightRun.rate(recovery, sample -> sample.lux() >= THRESHOLD)),
            "of all frames"),
        new Page.Row(
            "time until the light was back",
            "not told",
            back.count() == 0
                ? "it never was"
                : String.format(
                    Locale.ROOT,
                    "%.1f s in the mean, in %d of %d runs",
                    back.mean(),
                    back.count(),
                    recovery.size()),
            "from the fall on, looked at five times a second; a lamp takes %s s"
                .formatted(settings.value(Physics.setting(LAMP_SECONDS)))));
  }

  private static String percent(double share) {
    return Double.isNaN(share) ? "none" : String.format(Locale.ROOT, "%.1f %%", 100 * share);
  }
}
