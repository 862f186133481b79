package org.maestro.ontology.home;

import java.util.Optional;

/**
 * The access list of a home that changes now and then: read once for each state of it, as that goes
 * through all that is there. For one thread.
 */
public final class LatestAccess {
  private Optional<Read> latest = Optional.empty();

  private record Read(Home home, AccessList list) {}

  /** The list of the home as it is now. */
  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  public AccessList of(Home now) {
    Read read =
        latest.filter(one -> one.home() == now).orElseGet(() -> new Read(now, AccessList.of(now)));
    latest = Optional.of(read);
    return read.list();
  }
}
