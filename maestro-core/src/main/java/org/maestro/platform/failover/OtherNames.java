package org.maestro.platform.failover;

import java.util.function.Function;
import org.maestro.rats.link.RatsLink;

/**
 * Names of containers, under which this process can call on the bus in their place. Any thread may
 * call.
 */
public interface OtherNames {

  /** Whether anybody may use the name now: who was taken out of a site, does no more. */
  boolean mayBeUsed(String controller);

  /** A connection of its own under that name; closed by whoever asked for it. */
  RatsLink connect(String controller);

  /** Names that nobody takes out of anything. */
  static OtherNames unrestricted(Function<String, RatsLink> connect) {
    return new OtherNames() {
      @Override
      public boolean mayBeUsed(String controller) {
        return true;
      }

      @Override
      public RatsLink connect(String controller) {
        return connect.apply(controller);
      }
    };
  }
}
