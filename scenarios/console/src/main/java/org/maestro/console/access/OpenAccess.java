package org.maestro.console.access;

import java.util.Optional;
import org.maestro.rats.security.Role;

/** An open site: whoever is on this machine may all, as with JADE's port. */
public final class OpenAccess implements Access {
  private static final Visit ANYBODY =
      new Visit(Optional.empty(), Optional.of(Role.ADMINISTRATOR), Optional.empty(), () -> true);

  @Override
  public boolean isSecured() {
    return false;
  }

  @Override
  public Visit admit(Presented presented, Optional<Role> needed) {
    return ANYBODY;
  }

  @Override
  public Visit signIn(String name, String password, String address) {
    throw new DeniedException(
        DeniedException.Reason.FORBIDDEN,
        "This site is open, and nobody signs in; ./maestro run --security DIR runs a secured one.");
  }

  @Override
  public void signOut(Visit visit) {
    // Nobody has signed in.
  }
}
