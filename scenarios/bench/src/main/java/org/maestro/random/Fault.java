package org.maestro.random;

import java.time.Duration;
import org.maestro.hal.Position;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.world.Flaw;
import org.maestro.sim.world.World;

/** Something that goes wrong, or that somebody does, at a time after the goals were stated. */
public sealed interface Fault {

  Duration at();

  /** The targets of faults: world, bus, clock and main process. */
  interface Stage {
    World world();

    InProcessBus bus();

    Clock clock();

    /** The main process does nothing for so long, while devices and bus go on. */
    void freezeMain(Duration lasting);
  }

  /** Makes it happen now. */
  void strike(Stage stage);

  /** The device loses its power. */
  record Death(Duration at, String device) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.world().die(device);
    }
  }

  /** A dead device gets its power back. */
  record Revival(Duration at, String device) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.world().revive(device);
    }
  }

  /** The member goes from the bus, and works on by itself. */
  record Cut(Duration at, String member) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.bus().cut(member);
    }
  }

  /** It comes back. */
  record Return(Duration at, String member) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.bus().mend(member);
    }
  }

  /** Latency added to all that the member says, for a while. */
  record Delay(Duration at, String member, Duration extra, Duration lasts) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.bus().slow(member, extra);
      stage.clock().schedule(lasts, member, () -> stage.bus().slow(member, Duration.ZERO));
    }
  }

  /** The lamp gives another share of what the home says of it. */
  record Weakness(Duration at, String lamp, double strength) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.world().weaken(lamp, strength);
    }
  }

  /** The device is broken from now on, and does not say so. */
  record Flawed(Duration at, String device, Flaw flaw) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.world().flaw(device, flaw);
    }
  }

  /** A stranger puts the thing elsewhere, out of whatever hand it is in. */
  record Moved(Duration at, String thing, Position to) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.world().moveByHand(thing, to);
    }
  }

  /** The thing falls out of the hand that holds it, if any does, where the holder is. */
  record Dropped(Duration at, String thing) implements Fault {
    private static final double BESIDE_METRES = 0.45;

    @Override
    public void strike(Stage stage) {
      World world = stage.world();
      if (world.holder(thing).isPresent()) {
        Position place = world.position(thing).orElseThrow();
        world.moveByHand(thing, new Position(place.x() + BESIDE_METRES, place.y(), place.z()));
      }
    }
  }

  /** The thing is put into a cupboard where it stands, or taken out again. */
  record Hidden(Duration at, String thing, boolean away) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.world().hide(thing, away);
    }
  }

  /** The broker is killed, and comes back without what it knew. */
  record BrokerDown(Duration at, Duration lasts) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.bus().stop();
      stage.clock().schedule(lasts, "broker", stage.bus()::restart);
    }
  }

  /** The main process is stopped, as by a signal, and goes on as if nothing had been. */
  record Frozen(Duration at, Duration lasts) implements Fault {
    @Override
    public void strike(Stage stage) {
      stage.freezeMain(lasts);
    }
  }

  /**
   * Something else that disturbs the bus, and ends by itself.
   *
   * @param lasts how long it takes until nothing of it is left
   */
  record Disturbed(Duration at, String name, Duration lasts, BusDeed deed) implements Fault {
    @Override
    public void strike(Stage stage) {
      deed.begin(stage.bus(), stage.clock());
    }

    @Override
    public String toString() {
      return "%s at %d ms, for %d ms".formatted(name, at.toMillis(), lasts.toMillis());
    }
  }

  /** An action that disturbs the bus. */
  interface BusDeed {
    void begin(InProcessBus bus, Clock clock);
  }
}
