package org.maestro.troubleshooting;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.tree.CompilationUnitTree;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.language.Language;
import org.maestro.language.grammar.GrammarReader;
import org.maestro.language.grammar.ReportRule;

/**
 * What the platform says of goals in English can be said in German: each text of the packages that
 * are named here is that of a rule of {@code de.reports}, or a part of one.
 */
class GermanReportsTest {
  private static final Path ROOT = Path.of("../..");
  private static final String FILE = "de.reports";

  /** Packages and classes whose texts are all there. */
  private static final List<String> COMPLETE =
      List.of(
          "coordination.story.GoalStory",
          "coordination.story.KnownOf",
          "coordination.story.NewsSentences",
          "coordination.story.ObstacleSentences",
          "coordination.story.ProposalSentences",
          "coordination.story.SearchSentences",
          "coordination.story.WitnessSentences",
          "coordination.api.WaitsFor",
          "coordination.api.Roster",
          "coordination.achievement",
          "coordination.agenda",
          "coordination.lessons",
          "coordination.limits",
          "coordination.maintenance",
          "coordination.recovery",
          "coordination.allocation",
          "agents.negotiation.ContractNetRound",
          "agents.negotiation.Contracts",
          "agents.negotiation.OrderUnderway",
          "agents.negotiation.QuoteReader",
          "device.tasks",
          "rats.link.OpenCalls",
          "rats.link.Roster",
          "rats.link.BusLink",
          "sim.drivers.Grasp",
          "sim.drivers.SimulatedAppliance",
          "sim.drivers.SimulatedArm",
          "sim.drivers.SimulatedBase",
          "sim.drivers.SimulatedBattery",
          "sim.drivers.SimulatedDoor",
          "sim.drivers.SimulatedField",
          "sim.drivers.SimulatedFingers",
          "sim.drivers.SimulatedLamp");

  /** Told to who configures devices, before anything runs. */
  private static final Set<String> OF_CONFIGURATION =
      Set.of(
          "The device … offers …, but its driver is no …. Give it another driver, or take the feature away.",
          "The device … offers … with the procedure …, which is none of ….",
          "The device … offers …, whose input … is no setting of it; it has …. Say maestro:setting of the device or its class, or take the feature away.");

  private static List<ReportRule> rules;
  private static List<CompilationUnitTree> units;

  @BeforeAll
  static void read() throws IOException {
    units = SourceMessages.units(ROOT);
    try (InputStream stream = Language.class.getResourceAsStream(FILE)) {
      rules =
          GrammarReader.read(new String(stream.readAllBytes(), StandardCharsets.UTF_8), FILE)
              .reports();
    }
  }

  private static String place(CompilationUnitTree unit) {
    String file = Path.of(unit.getSourceFile().getName()).getFileName().toString();
    return (unit.getPackageName() + "." + file.replace(".java", ""))
        .replaceFirst("^org\\.maestro\\.", "");
  }

  private static boolean isOf(String place, String named) {
    return (place + ".").startsWith(named + ".");
  }

  @Test
  void haveARuleForEachTextOfThePackagesThatAreComplete() {
    List<String> written = rules.stream().map(rule -> filledIn(rule.text())).toList();
    List<String> missing = new ArrayList<>();
    for (CompilationUnitTree unit : units) {
      String place = place(unit);
      if (COMPLETE.stream().anyMatch(named -> isOf(place, named))) {
        UnitReports.of(unit).stream()
            .filter(text -> !OF_CONFIGURATION.contains(text))
            .filter(text -> written.stream().noneMatch(fits(text).asMatchPredicate()))
            .forEach(text -> missing.add(place + ": " + text));
      }
    }

    assertThat(missing).as("texts without a rule in %s", FILE).isEmpty();
  }

  private static String filledIn(String text) {
    return text.replaceAll("\\{\\w+:\\w+}", Message.ANYTHING);
  }

  /** What has the words of the text, all of them in that order. */
  private static Pattern fits(String text) {
    return Pattern.compile(
        Stream.of(text.strip().replaceAll("\\.$", "").split(Message.ANYTHING, -1))
            .map(part -> Pattern.quote(part.strip()))
            .collect(Collectors.joining(".*", ".*?", ".*")),
        Pattern.CASE_INSENSITIVE);
  }

  @Test
  void thePackagesThatAreCompleteAreThere() {
    List<String> places = units.stream().map(GermanReportsTest::place).toList();

    assertThat(COMPLETE).allMatch(named -> places.stream().anyMatch(place -> isOf(place, named)));
  }
}
