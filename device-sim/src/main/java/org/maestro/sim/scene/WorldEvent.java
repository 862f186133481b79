package org.maestro.sim.scene;

import java.time.Duration;
import java.util.Optional;

/**
 * Something that happened in the world.
 *
 * @param at simulated time since the start
 * @param subject the device, or the thing that was moved by hand
 * @param thing the thing concerned
 */
public record WorldEvent(Duration at, Kind kind, String subject, Optional<String> thing) {

  /** The first seven are commands that a device's driver received, before they take effect. */
  public enum Kind {
    ADJUST,
    LOOK,
    READ,
    DRIVE,
    GRASP,
    RELEASE,
    TRANSMIT,
    LIT,
    DRIVEN,
    MEASURED,
    BLOCKED,
    PICKED,
    PLACED,
    DROPPED,
    OPENED,
    CLOSED,
    SWITCHED,
    DIED,
    REVIVED,
    MOVED,
    /** A battery holds a step less, or more. */
    DRAINED,
    /** A battery is empty. */
    EMPTIED,
    /** A robot that drives touches another body that moves. */
    COLLIDED,
    /** A robot has sent what it had to send. */
    TRANSMITTED,
    /** A face shows something else. */
    FACED
  }

  /** Told on the thread that caused the event, mostly the clock's; may change the world. */
  public interface Listener {
    void happened(WorldEvent event);
  }
}
