package org.maestro.console;

import io.javalin.http.Context;
import java.util.Optional;
import java.util.Set;
import org.maestro.console.access.Access;
import org.maestro.console.access.DeniedException;
import org.maestro.console.access.Presented;
import org.maestro.console.access.Visit;
import org.maestro.console.api.Operation;
import org.maestro.rats.security.Role;

/** The way in by HTTP: what a request brings, and what a browser is to bring from then on. */
final class Entrance {
  private static final Set<String> READING = Set.of("GET", "HEAD");
  private static final int WEEK_SECONDS = 604_800;

  private final Access access;

  Entrance(Access access) {
    this.access = access;
  }

  /**
   * Lets somebody in.
   *
   * @param needed the role that it takes; empty: none
   * @throws DeniedException when she may not
   */
  Visit admit(Context context, Optional<Role> needed) {
    return admit(context, needed, false);
  }

  /** The same for an operation. */
  Visit admit(Context context, Operation operation) {
    return admit(context, operation.needs(), operation.urgent());
  }

  private Visit admit(Context context, Optional<Role> needed, boolean urgent) {
    return access.admit(
        new Presented(
            context.ip(),
            Optional.ofNullable(context.header("Authorization")),
            Optional.ofNullable(context.cookie(cookie(context))),
            Optional.ofNullable(context.header("X-CSRF-Token")),
            !READING.contains(context.method().name()),
            urgent),
        needed);
  }

  /** Whether who asks may be told more than that all is well, or not. */
  boolean isKnown(Context context) {
    try {
      admit(context, Optional.of(Role.VIEWER));
      return true;
    } catch (DeniedException e) {
      return false;
    }
  }

  /** Has a browser bring the session's token; empty: none any more. */
  static void remember(Context context, Optional<String> session) {
    context.header(
        "Set-Cookie",
        "%s=%s; Path=/; Max-Age=%d; Secure; HttpOnly; SameSite=Strict"
            .formatted(
                cookie(context), session.orElse(""), session.isPresent() ? WEEK_SECONDS : 0));
  }

  /** Browsers keep cookies by host, and another platform may be at another port of it. */
  private static String cookie(Context context) {
    return "__Host-maestro-" + context.port();
  }
}
