package org.maestro.console.access;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.maestro.rats.security.Role;

/**
 * Somebody who is let in.
 *
 * @param person her name on the site; empty: nobody in particular
 * @param role empty: none
 * @param session empty: each request brings a password, or none is needed
 * @param lasts whether she is let in still, for what goes on after the request
 */
public record Visit(
    Optional<String> person,
    Optional<Role> role,
    Optional<Session> session,
    BooleanSupplier lasts) {

  static final Visit OF_NOBODY =
      new Visit(Optional.empty(), Optional.empty(), Optional.empty(), () -> false);
}
