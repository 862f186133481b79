package org.maestro.experiment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.experiment.EveningRun.Wanted;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Ink;
import org.maestro.experiment.drawing.Stacks;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Setting;
import org.maestro.ontology.home.Home;

/**
 * The same evening in several homes, each a file, run by run with the same seed: a virtual
 * environment in which set-ups are tried before anything is bought (ADE, 6; A93).
 */
final class SetUps implements Experiment {
  static final String NAME = "setups";
  private static final List<Stacks.Piece> ENDINGS =
      List.of(
          new Stacks.Piece(EveningRun.End.REACHED.label(), Ink.GREEN),
          new Stacks.Piece(EveningRun.End.SAID_ONLY.label(), Ink.SKY),
          new Stacks.Piece(EveningRun.End.NOT_REACHED.label(), Ink.GREY),
          new Stacks.Piece(EveningRun.End.FALSELY_CLAIMED.label(), Ink.RED));

  private final Supplier<Comparison> compared;

  /**
   * @param compared is asked when runs begin
   */
  SetUps(Supplier<Comparison> compared) {
    this.compared = compared;
  }

  /** Bob's home with one robot and with two, where nobody names others. */
  static Comparison shipped() {
    Home one = Shipped.home("bob");
    Home two = Shipped.home("bob-two-robots");
    return new Comparison(
        List.of(
            new Comparison.SetUp("bob", one, Shipped.scene("bob-two-robots", one, List.of(two))),
            new Comparison.SetUp("bob-two-robots", two, Shipped.scene("bob-two-robots", two))),
        List.of(Wish.of("(nextTo Cup Bob)"), Wish.of("(in Cup zone-b)")),
        "");
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public String purpose() {
    return "the same evening in two homes or more, each a file: one table (ADE, section 6)";
  }

  @Override
  public int usualRuns() {
    return 6;
  }

  /** Homes of others may have all that can be simulated. */
  @Override
  public List<Setting> settings() {
    return Physics.all();
  }

  @Override
  public Course<?> begin(Request request) {
    Comparison comparison = compared.get();
    return new Course<>(
        request.runs(),
        run -> inEach(comparison, request, run),
        SetUps::inWords,
        all -> findings(comparison, request, new Compared(comparison, all)));
  }

  private static List<EveningRun> inEach(Comparison comparison, Request request, int run) {
    return comparison.setUps().stream()
        .map(
            setUp ->
                Evening.pass(
                    run,
                    request.seedOf(run),
                    setUp,
                    comparison.wishes(),
                    Physics.of(request.settings()),
                    run == 1))
        .toList();
  }

  private static String inWords(List<EveningRun> evenings) {
    return evenings.stream()
        .map(
            run ->
                "%s reached %d of %d in %d s"
                    .formatted(
                        run.setUp(), run.reached(), run.wanted().size(), Math.round(run.seconds())))
        .collect(Collectors.joining(", "));
  }

  private static Findings findings(Comparison comparison, Request request, Compared compared) {
    Map<String, Table> tables = new LinkedHashMap<>();
    tables.put("runs", runs(compared));
    tables.put("comparison", comparison(compared));
    tables.put("light", light(compared));
    tables.put("story", story(compared));
    List<Figure> figures = figures(compared);
    List<String> sentences =
        Stream.concat(
                compared.claims().stream(),
                compared.undone().stream().map(Compared.Undone::sentence))
            .toList();
    return new Findings(
            NAME,
            compared.results(),
            tables,
            figures,
            SetUpsPage.of(request, comparison, compared, figures))
        .summed(new Findings.Summary(comparison(compared), sentences));
  }

  /** The one table: a row for each figure, a column for each home and each difference. */
  static Table comparison(Compared compared) {
    List<String> names = compared.names();
    List<String> columns = new ArrayList<>(List.of(""));
    columns.addAll(names);
    names.stream()
        .skip(1)
        .forEach(
            name -> columns.add("%s more than %s (95 %% interval)".formatted(name, names.get(0))));
    Table table = new Table(columns.toArray(String[]::new));
    for (Measure measure : compared.measures()) {
      List<Object> cells = new ArrayList<>(List.of(measure.heading()));
      cells.addAll(measure.cells());
      IntStream.range(1, names.size()).forEach(home -> cells.add(measure.difference(home)));
      table.add(cells.toArray());
    }
    return table;
  }

  private static Stream<EveningRun> all(Compared compared) {
    return IntStream.range(0, compared.names().size())
        .boxed()
        .flatMap(home -> compared.of(home).stream());
  }

  private static Table runs(Compared compared) {
    Table table =
        new Table(
            "run",
            "seed",
            "goal",
            "success",
            "duration_s",
            "lower_bound_s",
            "replans",
            "failure",
            "setup",
            "end",
            "calls",
            "evening_s",
            "evening_wh");
    all(compared)
        .forEach(
            run -> {
              for (Wanted wanted : run.wanted()) {
                table.add(
                    run.number(),
                    run.seed(),
                    wanted.wish().goal(),
                    wanted.isReached(),
                    wanted.seconds(),
                    Double.NaN,
                    wanted.ending().replans(),
                    wanted.failure(),
                    run.setUp(),
                    wanted.end().label(),
                    wanted.ending().calls(),
                    run.seconds(),
                    run.wattHours());
              }
            });
    return table;
  }

  private static Table light(Compared compared) {
    Table table = new Table("run", "setup", "zone", "mean_lux");
    all(compared)
        .forEach(
            run ->
                run.lux().forEach((zone, lux) -> table.add(run.number(), run.setUp(), zone, lux)));
    return table;
  }

  private static Table story(Compared compared) {
    Table table = new Table("run", "setup", "goal", "t_s", "kind", "text");
    all(compared)
        .forEach(
            run -> {
              for (Wanted wanted : run.wanted()) {
                for (StoryEntry entry : wanted.ending().story()) {
                  table.add(
                      run.number(),
                      run.setUp(),
                      wanted.wish().goal(),
                      entry.at().minus(wanted.ending().begun()).toMillis() / 1e3,
                      entry.kind(),
                      entry.text());
                }
              }
            });
    return table;
  }

  private static List<Figure> figures(Compared compared) {
    List<Figure> figures = new ArrayList<>();
    figures.add(
        Figure.of(
            "endings",
            "How the goals of all runs ended in each home, with the same seeds.",
            Stacks.draw(
                "How goals ended",
                "goals",
                ENDINGS,
                IntStream.range(0, compared.names().size())
                    .mapToObj(
                        home ->
                            new Stacks.Stack(compared.names().get(home), counts(compared.of(home))))
                    .toList())));
    all(compared)
        .forEach(
            run ->
                run.pictures()
                    .forEach(
                        picture ->
                            figures.add(
                                new Figure(
                                    "setup-"
                                        + (1 + compared.names().indexOf(run.setUp()))
                                        + "-"
                                        + picture.name(),
                                    "%s: %s".formatted(run.setUp(), picture.caption()),
                                    picture.png()))));
    return List.copyOf(figures);
  }

  private static List<Integer> counts(List<EveningRun> runs) {
    return Arrays.stream(EveningRun.End.values())
        .map(
            end ->
                (int)
                    runs.stream()
                        .flatMap(run -> run.wanted().stream())
                        .filter(wanted -> wanted.end() == end)
                        .count())
        .toList();
  }
}
