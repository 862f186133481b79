package org.maestro.chaos;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.maestro.random.Fault;
import org.maestro.random.RandomHome;
import org.maestro.sim.world.Flaw;

/** Draws one of the homes that come with the platform, what is asked in it, and what breaks. */
final class ShippedHomes {
  private static final int LATEST_MILLIS = 20_000;

  private static final List<String> GOALS =
      List.of(
          "(nextTo Cup Bob)",
          "(nextTo Cup Bob)",
          "(in Cup zone-a)",
          "(in Cup zone-b)",
          "(in Cup rose)",
          "(in rose zone-a)",
          "(in rose zone-b)",
          "(not (in Cup zone-b))",
          "(canSee ?agent Cup)",
          "(canSee cam-b Cup)",
          "(canSee cam-a Bob)",
          "(>= (illuminance zone-a) 90)",
          "(>= (illuminance zone-b) 72)",
          "(>= (illuminance zone-b) 150)",
          "(<= (level lamp-a1) 0.5)",
          "(keep (>= (illuminance zone-b) 80))",
          "(and (in rose zone-a) (>= (illuminance zone-b) 72))");

  private static final List<String> SCENES =
      List.of("bob-dark", "bob-lit", "bob-cup-in-a", "bob-hidden", "bob-weak-lamps");

  private static final List<String> LAMPS =
      List.of("lamp-a1", "lamp-a2", "lamp-b1", "lamp-b2", "lamp-b3");

  private static final List<String> DEVICES =
      List.of("rose", "rose", "rose", "cam-a", "cam-b", "lux-a", "lux-b", "lamp-b1", "lamp-b2");

  private final Random random;

  private ShippedHomes(long seed) {
    this.random = new Random(seed * 0x2545F4914F6CDD1DL);
  }

  /** The same seed, the same of all. */
  static RandomHome of(long seed) {
    return new ShippedHomes(seed).drawn(seed);
  }

  private RandomHome drawn(long seed) {
    boolean two = random.nextInt(4) == 0;
    String scene = two ? "bob-two-robots" : one(SCENES);
    List<String> goals = new ArrayList<>();
    for (int count = 1 + random.nextInt(3); count > 0; count--) {
      goals.add(one(GOALS));
    }
    return new RandomHome(
        seed,
        text("/homes/" + (two ? "bob-two-robots" : "bob") + ".ttl"),
        text("/scenes/" + scene + ".ttl"),
        goals,
        faults());
  }

  private List<Fault> faults() {
    List<Fault> faults = new ArrayList<>();
    for (int count = random.nextInt(3); count > 0; count--) {
      String device = one(DEVICES);
      switch (random.nextInt(6)) {
        case 0 -> faults.add(new Fault.Death(time(), device));
        case 1, 2 -> {
          Duration at = time();
          faults.add(new Fault.Cut(at, device));
          faults.add(new Fault.Return(at.plus(time()), device));
        }
        case 3 -> faults.add(new Fault.Weakness(time(), one(LAMPS), 0.2 + random.nextDouble() / 2));
        case 4 -> faults.add(new Fault.Flawed(Duration.ZERO, "rose", one(lies())));
        default -> faults.add(new Fault.Dropped(time(), "Cup"));
      }
    }
    faults.sort(Comparator.comparing(Fault::at));
    return faults;
  }

  private static List<Flaw> lies() {
    return List.of(Flaw.IDLE, Flaw.BOASTING, Flaw.STANDING, Flaw.SPINNING);
  }

  private Duration time() {
    return Duration.ofMillis(random.nextInt(LATEST_MILLIS));
  }

  private <T> T one(List<T> of) {
    return of.get(random.nextInt(of.size()));
  }

  private static String text(String resource) {
    try (InputStream turtle = ShippedHomes.class.getResourceAsStream(resource)) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
