package org.maestro.console;

import io.javalin.http.Context;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * The rules for which requests are looked at: those of pages of other sites, and for names that
 * others may point at this machine, are not. What browsers are to do with the answers is said here
 * too.
 */
final class Gatekeeper {
  private static final Set<String> OF_OURS = Set.of("same-origin", "none");

  /** Our own files alone, and no frame around the page. */
  private static final String POLICY =
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:;"
          + " connect-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none';"
          + " frame-ancestors 'none'";

  private final Serving serving;

  Gatekeeper(Serving serving) {
    this.serving = serving;
  }

  /** Headers of every answer. */
  static void mark(Context context) {
    context
        .header("Content-Security-Policy", POLICY)
        .header("X-Content-Type-Options", "nosniff")
        .header("Referrer-Policy", "no-referrer")
        .header("Cross-Origin-Resource-Policy", "same-origin")
        .header("Cache-Control", "no-store");
  }

  /** Why the request is not answered; empty when it is. */
  Optional<String> objection(Context context) {
    String host = Optional.ofNullable(context.header("Host")).orElse("");
    if (!serving.names().contains(name(host))) {
      return Optional.of(
          serving.security().isPresent()
              ? "The console does not answer under this name; ./maestro secure DIR --host NAME adds it."
              : "The console answers on this machine alone: ask for 127.0.0.1 or localhost.");
    }
    Optional<String> origin = Optional.ofNullable(context.header("Origin"));
    if (origin.isPresent() && !origin.get().equalsIgnoreCase(serving.scheme() + "://" + host)
        || Optional.ofNullable(context.header("Sec-Fetch-Site"))
            .filter(site -> !OF_OURS.contains(site))
            .isPresent()) {
      return Optional.of("The request comes from a page of another site, which may ask nothing.");
    }
    return Optional.ofNullable(context.header("X-HTTP-Method-Override"))
        .map(other -> "X-HTTP-Method-Override is not heeded; send the method itself.");
  }

  /** The host without its port. */
  private static String name(String host) {
    int colon = host.lastIndexOf(':');
    boolean isWithPort = colon > host.lastIndexOf(']');
    return (isWithPort ? host.substring(0, colon) : host).toLowerCase(Locale.ROOT);
  }
}
