package org.maestro.console.access;

import java.util.Optional;
import org.maestro.rats.security.Role;

/** The rules for who is let in. Any thread. */
public interface Access {
  /** Whether persons have to sign in. */
  boolean isSecured();

  /**
   * Lets somebody in.
   *
   * @param needed the role that it takes; empty: none, and who brings nothing is nobody
   * @throws DeniedException when there is no such person, or she may not
   */
  Visit admit(Presented presented, Optional<Role> needed);

  /**
   * Begins a session; a visit that has one.
   *
   * @throws DeniedException when the name or the password is wrong, or it was tried too often
   */
  Visit signIn(String name, String password, String address);

  /** Ends a session, if there is one. */
  void signOut(Visit visit);
}
