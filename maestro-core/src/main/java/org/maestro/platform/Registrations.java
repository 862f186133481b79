package org.maestro.platform;

import java.util.Optional;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.runtime.Caller;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.DeploymentException;
import org.maestro.platform.guard.Guard;
import org.maestro.rats.security.Role;
import org.maestro.rats.security.SitePersons;

/**
 * Who may have agents that the supervisor has not started, or is to start elsewhere (ADE, 3.1;
 * A20). Its certificate lets a process in; on a secured site somebody who may add agents has to
 * answer for one that is started there by hand, by name and password. Any thread may ask.
 */
final class Registrations {
  private final Optional<Guard> guard;

  /**
   * @param guard of a secured site; on an open one whoever registers is taken in
   */
  Registrations(Optional<Guard> guard) {
    this.guard = guard;
  }

  /**
   * @throws DeploymentException when the caller's process may have no agents of members
   */
  void requireHost(Caller caller) {
    if (guard.filter(its -> caller.user().filter(its::isGuest).isPresent()).isPresent()) {
      throw new DeploymentException(
          "%s is of a guest, whose process may ask and has no agents of members; join as a container of the site (./maestro secure --controller)."
              .formatted(caller));
    }
  }

  /**
   * Takes about a tenth of a second of a processor on a secured site.
   *
   * @throws DeploymentException when the agent is not taken in, with the reason
   */
  void require(AgentStart start, Caller caller, Optional<StartWords.Shown> shown) {
    requireHost(caller);
    if (guard.isEmpty()) {
      return;
    }
    if (shown.isEmpty()) {
      throw new DeploymentException(
          "The agent %s was started by hand and shows no user name and password; give it the name of an administrator of this site, and the file with her password, as its second and third argument."
              .formatted(start.agent()));
    }
    SitePersons persons = guard.get().persons();
    String person = shown.get().person();
    if (!persons.isPassword(person, shown.get().password())) {
      throw new DeploymentException(
          "The agent %s was started by hand in the name of %s, and the password is not that of a person of this site who is called so."
              .formatted(start.agent(), person));
    }
    if (persons.role(person).filter(role -> role.includes(Role.ADMINISTRATOR)).isEmpty()) {
      throw new DeploymentException(
          "%s may start no agent by hand; administrators of this site may.".formatted(person));
    }
  }
}
