package org.maestro.knowledge.habits;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.DayOfWeek;
import java.time.Duration;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;

/** How often rose was in a zone at about this time of day. */
class HabitsTest {
  private static final Source HERSELF = new Source(Source.Kind.STATED, "rose");
  private static final String VISITS =
      """

      home:visits a maestro:Fluent ; rdfs:label "visits"@en ;
        maestro:arguments ( "?robot - MobileRobot" "?zone - Zone" ) ; maestro:countedWhen "(in ?robot ?zone)" .
      """;
  private static Home home;

  private final SteppedClock clock = new SteppedClock();
  private final List<String> kept = new ArrayList<>();
  private KnowledgeBase knowledge;
  private Habits habits;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = ResourceClaimsTest.class.getResourceAsStream("/narrow.ttl")) {
      String text = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      home = new HomeLoader().load(text + VISITS, "narrow.ttl").in(ZoneOffset.UTC);
    }
  }

  @BeforeEach
  void monday() {
    while (clock.instant().atZone(ZoneOffset.UTC).getDayOfWeek() != DayOfWeek.MONDAY) {
      clock.run(Duration.ofHours(1));
    }
    begin(new Kept());
  }

  private void begin(HabitLog log) {
    knowledge = new CollectiveKnowledge(home, clock);
    habits = new Habits(knowledge, clock, log);
    knowledge.watch(
        change -> {
          if (habits.concerns(change)) {
            clock.schedule(Duration.ZERO, "habits", habits::look);
          }
        });
    habits.begin();
  }

  private void goesTo(String zone) {
    knowledge.state(HERSELF, List.of("(in rose %s)".formatted(zone)));
    clock.run(Duration.ofSeconds(1));
  }

  private OptionalDouble visits(String zone) {
    habits.tell();
    return knowledge
        .snapshot()
        .number((Expression.Fluent) SlParser.expression("(visits rose %s)".formatted(zone)));
  }

  /** There and back again. */
  private void visit(String zone) {
    goesTo(zone);
    goesTo("zone-c");
  }

  @Test
  void whatBecomesSoAboutTheSameTimeIsCounted() {
    visit("zone-a");
    clock.run(Duration.ofDays(1));
    visit("zone-a");
    clock.run(Duration.ofDays(1).plusHours(1));
    visit("zone-a");

    assertThat(visits("zone-a")).hasValue(3);
    assertThat(visits("zone-b")).as("nobody has ever seen it").isEmpty();
    assertThat(knowledge.history("(= (visits rose zone-a) 3)").get(0).source().agent())
        .isEqualTo("habits");
  }

  @Test
  void atAnotherTimeOfDayItIsNone() {
    visit("zone-a");
    clock.run(Duration.ofHours(5));

    assertThat(visits("zone-a")).hasValue(0);
    clock.run(Duration.ofHours(18));
    assertThat(visits("zone-a")).as("23 hours later").hasValue(1);
  }

  @Test
  void theWeekendIsAMatterOfItsOwn() {
    visit("zone-a");
    clock.run(Duration.ofDays(5));
    assertThat(visits("zone-a")).as("on Saturday").hasValue(0);
    clock.run(Duration.ofDays(2));
    assertThat(visits("zone-a")).as("on Monday").hasValue(1);
  }

  @Test
  void toAndFroIsOneVisit() {
    visit("zone-a");
    clock.run(Duration.ofMinutes(20));
    visit("zone-a");

    assertThat(visits("zone-a")).hasValue(1);
  }

  @Test
  void whatWasCountedIsKnownAfterARestart(@TempDir Path directory) {
    begin(new HabitFile(directory));
    visit("zone-a");
    begin(new HabitFile(directory));

    assertThat(visits("zone-a")).hasValue(1);
    clock.run(Duration.ofDays(61));
    begin(new HabitFile(directory));
    assertThat(visits("zone-a")).as("long ago").isEmpty();
  }

  @Test
  void aLineThatCannotBeReadIsPassedOver() {
    visit("zone-a");
    kept.add("yesterday (visits rose zone-a)");
    kept.add("");
    kept.add(clock.instant() + " (visits rose");
    begin(new Kept());

    assertThat(visits("zone-a")).hasValue(1);
  }

  private final class Kept implements HabitLog {
    @Override
    public List<String> lines() {
      return List.copyOf(kept);
    }

    @Override
    public void add(String line) {
      kept.add(line);
    }
  }
}
