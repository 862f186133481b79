package org.maestro.launch;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.PastDays;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.documents.JsonMembers;
import org.maestro.coordination.api.Speech;
import org.maestro.dialogue.Utterance;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.SteppedClock;

/**
 * The evening of ADE's introduction (1; A1, A3 to A6): somebody comes home, is welcomed, and has a
 * drink and dinner. What the house does comes from the home's file; here stands what the person
 * says, and by what the evening is judged in the simulated world. One thread.
 */
final class FamilyEvening {
  static final String NAME = "evening";
  private static final String SCENE = "homecoming";
  private static final String PERSON = "Dave";
  private static final String MEAL = "pasta-1";
  private static final DateTimeFormatter CLOCK =
      DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);
  private static final LocalTime BEGINS = LocalTime.of(18, 5);
  private static final Duration STEP = Duration.ofSeconds(1);
  private static final Duration LONGEST = Duration.ofMinutes(90);
  private static final Duration SITS = Duration.ofSeconds(20);
  private static final double LIGHT_LUX = 150;

  private static final String HELLO = "Hello Dave, I hope you had a good day at work.";
  private static final String WISH = "Dave, what would you like for dinner?";
  private static final String LATER =
      "Dave, would you like me to hold off on heating dinner for a while?";
  private static final String READY = "Dinner is ready.";

  /** What he says to what is asked. */
  private static final Map<String, String> ANSWERS =
      Map.of(WISH, "The pasta, please.", LATER, "Yes, half an hour.");

  private static final Duration HALF_AN_HOUR = Duration.ofMinutes(30);

  private final boolean wine;
  private final long seed;
  private final Optional<PrintWriter> out;
  private final List<Said> heard = new CopyOnWriteArrayList<>();
  private final List<Claim> claims = new ArrayList<>();
  private int answered;
  private Optional<Duration> sits = Optional.empty();
  private Optional<Duration> lit = Optional.empty();
  private Optional<Duration> shown = Optional.empty();
  private Optional<Duration> agreed = Optional.empty();
  private Optional<String> toldIn = Optional.empty();
  private boolean isServed;
  private boolean isSaidToHimAlone = true;

  private record Said(Speech speech, Duration at) {}

  private record Claim(String sentence, boolean holds) {}

  /**
   * @param wine whether he has wine, not scotch
   * @param out where it is told as it happens, if anywhere
   */
  FamilyEvening(boolean wine, long seed, Optional<PrintWriter> out) {
    this.wine = wine;
    this.seed = seed;
    this.out = out;
  }

  /**
   * @param stories where the stories of its goals are kept
   */
  void run(Path stories) {
    Path past = temporary();
    try {
      PastDays.shipped(NAME).keepIn(past, new SteppedClock().start());
      Home home = Shipped.home(NAME);
      out.ifPresent(
          where -> {
            where.println(Shipped.introduction(SCENE));
            where.println();
          });
      try (LocalSite site =
          LocalSite.stepped(
              SiteSettings.of(NAME, home)
                  .scene(Shipped.scene(SCENE, home))
                  .seed(seed)
                  .storyDirectory(stories)
                  .dataDirectory(past)
                  .build())) {
        live(site, new ChangesOfDevices(site));
      }
    } finally {
      delete(past);
    }
  }

  private void live(LocalSite site, ChangesOfDevices devices) {
    site.platform().desk().whenSaid(speech -> heard.add(new Said(speech, site.clock().now())));
    Duration end = site.clock().now().plus(LONGEST);
    int told = 0;
    while (said(READY).isEmpty() && site.clock().now().compareTo(end) < 0) {
      site.runUntil(() -> false, STEP);
      devices.since().forEach(change -> tell(site.clock().now(), "", change));
      for (; told < heard.size(); told++) {
        Said one = heard.get(told);
        tell(one.at(), "to " + home(site, one.speech().to()), "\"" + one.speech().text() + "\"");
      }
      look(site, devices);
      speak(site);
    }
    judge(site, devices);
  }

  private static String home(LocalSite site, String name) {
    return Optional.ofNullable(site.home().individuals().get(name))
        .map(one -> one.label())
        .orElse(name);
  }

  private void look(LocalSite site, ChangesOfDevices devices) {
    Duration now = site.clock().now();
    if (lit.isEmpty() && site.world().lux("livingroom") >= LIGHT_LUX) {
      lit = Optional.of(now);
    }
    if (shown.isEmpty() && devices.value("tv", "selection").equals("EveningNews")) {
      shown = Optional.of(now);
    }
    if (sits.isEmpty() && site.world().zone(PERSON).equals(Optional.of("livingroom"))) {
      sits = Optional.of(now);
    }
    isServed |= devices.value("bar", "drink").equals(wine ? "Wine" : "Scotch");
    if (toldIn.isEmpty() && !said(READY).isEmpty()) {
      toldIn = site.world().zone(PERSON);
    }
  }

  /** He answers what he is asked, and asks for his drink once he sits. */
  private void speak(LocalSite site) {
    for (; answered < heard.size(); answered++) {
      String to = heard.get(answered).speech().to();
      isSaidToHimAlone &= to.equals(PERSON) || site.world().zone(PERSON).equals(Optional.of(to));
      String question = heard.get(answered).speech().text();
      Optional.ofNullable(ANSWERS.get(question)).ifPresent(answer -> say(site, answer));
      if (question.equals(LATER)) {
        agreed = Optional.of(site.clock().now());
      }
    }
    boolean isToAsk =
        sits.map(since -> since.plus(SITS)).filter(site.clock().now()::equals).isPresent();
    if (isToAsk) {
      say(site, wine ? "I'd like a glass of wine, please." : "I'd like a scotch, please.");
    }
  }

  private void say(LocalSite site, String words) {
    tell(site.clock().now(), PERSON, "\"" + words + "\"");
    String room = site.world().zone(PERSON).orElse("");
    site.platform().desk().say(new Utterance(PERSON, room, words, Optional.empty()), reply -> {});
  }

  private void tell(Duration at, String who, String what) {
    out.ifPresent(
        where -> {
          where.printf(Locale.ROOT, "%s  %-20s %s%n", CLOCK.format(BEGINS.plus(at)), who, what);
          where.flush();
        });
  }

  private List<Said> said(String text) {
    return heard.stream().filter(one -> one.speech().text().equals(text)).toList();
  }

  private void judge(LocalSite site, ChangesOfDevices devices) {
    claim("He is greeted in the hallway, once.", areSaid(HELLO, "hallway"));
    claim("The living room is light before he is there.", isLightBefore());
    claim("The television shows the news that he usually watches.", shown.isPresent());
    claim("He is asked what he wants for dinner, once.", said(WISH).size() == 1);
    claim("He gets his " + (wine ? "wine." : "scotch."), isServed);
    if (wine) {
      claim("Nobody asks whether dinner is to wait.", said(LATER).isEmpty());
    } else {
      claim("He is asked whether dinner is to wait, once.", said(LATER).size() == 1);
      claim("Dinner is ready half an hour after he has said so, or later.", isLater());
    }
    claim(
        "That dinner is ready is said in the room in which he is.",
        toldIn.filter(room -> areSaid(READY, room)).isPresent());
    claim("Nothing is said where he is not.", isSaidToHimAlone);
    claim(
        "The pasta is warm, and in the kitchen.",
        devices.value("microwave", "food").equals(MEAL)
            && !site.world().isHidden(MEAL)
            && site.world().zone(MEAL).equals(Optional.of("kitchen")));
    List<String> on = devices.on();
    on.removeAll(List.of("the television", "the refrigerator"));
    claim("Nothing that heats or plays is on but the television.", on.isEmpty());
    claim("The hallway is dark again.", level(site, "hall-lamp").orElse(1) == 0);
    claim("The front door is closed.", !site.world().isOpen("front-door"));
  }

  private void claim(String sentence, boolean holds) {
    claims.add(new Claim(sentence, holds));
  }

  private boolean areSaid(String text, String to) {
    List<Said> all = said(text);
    return all.size() == 1 && all.get(0).speech().to().equals(to);
  }

  private boolean isLightBefore() {
    return lit.isPresent() && sits.filter(later -> lit.get().compareTo(later) < 0).isPresent();
  }

  private boolean isLater() {
    return said(READY).stream()
        .map(Said::at)
        .anyMatch(
            at -> agreed.map(since -> at.minus(since).compareTo(HALF_AN_HOUR) >= 0).orElse(false));
  }

  private static OptionalDouble level(LocalSite site, String lamp) {
    return SimulatedTruth.of(site).now().stream()
        .filter(thing -> thing.name().equals(lamp))
        .flatMapToDouble(thing -> thing.level().stream())
        .findFirst();
  }

  /** What was to be so, and is not. */
  List<String> amiss() {
    return claims.stream().filter(claim -> !claim.holds()).map(Claim::sentence).toList();
  }

  boolean wentWell() {
    return amiss().isEmpty();
  }

  /** What is so in the simulated world, in sentences, or as a document where nothing was told. */
  void tell(PrintWriter to) {
    if (out.isEmpty()) {
      to.println(document());
      return;
    }
    to.println();
    claims.forEach(claim -> to.println((claim.holds() ? "yes  " : "no   ") + claim.sentence()));
    to.println();
    to.println("Try next:");
    to.println(
        wine
            ? "  ./maestro demo evening          the same with a scotch"
            : "  ./maestro demo evening --wine   the same with wine, after which dinner goes on");
    to.println("  ./maestro run evening --scene homecoming --speed 5 --console");
  }

  private String document() {
    JsonMembers document = JsonMembers.empty().truth("reached", wentWell());
    for (Claim claim : claims) {
      JsonMembers.in(document.node().withArray("claims"))
          .text("claim", claim.sentence())
          .truth("holds", claim.holds());
    }
    return document.toString();
  }

  private static Path temporary() {
    try {
      return Files.createTempDirectory("maestro-evening");
    } catch (IOException e) {
      throw CommandException.outside("There is no place for what was counted before.", e);
    }
  }

  private static void delete(Path directory) {
    try (Stream<Path> files = Files.walk(directory)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
