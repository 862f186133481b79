package org.maestro.console;

import java.net.InetSocketAddress;
import java.time.InstantSource;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.console.access.Access;
import org.maestro.console.access.OpenAccess;
import org.maestro.console.access.PersonsAccess;
import org.maestro.dialogue.Paraphraser;
import org.maestro.rats.security.SiteSecurity;

/**
 * The address at which a console is served, whom it serves, and whom it asks itself.
 *
 * @param host an address of this machine
 * @param port 0: a free one
 * @param security of a secured site, which is served by TLS and where persons sign in; empty:
 *     whoever is on this machine may all
 * @param paraphraser who is asked what was meant where nobody here understands it
 */
public record Serving(
    String host, int port, Optional<SiteSecurity> security, Paraphraser paraphraser) {
  public static final String LOOPBACK = "127.0.0.1";

  /** Where nobody else is asked. */
  public Serving(String host, int port, Optional<SiteSecurity> security) {
    this(host, port, security, Paraphraser.NOBODY);
  }

  /** Of an open site. */
  public static Serving onLoopback(int port) {
    return new Serving(LOOPBACK, port, Optional.empty());
  }

  /** Whether it is served at all addresses that this machine has. */
  boolean isEverywhere() {
    return new InetSocketAddress(host, port).getAddress().isAnyLocalAddress();
  }

  String scheme() {
    return security.isPresent() ? "https" : "http";
  }

  /** The names for this machine by which it may be asked for. */
  Set<String> names() {
    Set<String> names = new TreeSet<>(Set.of(LOOPBACK, "localhost", "[::1]"));
    security.ifPresent(
        files -> {
          names.add(inAddress(host));
          files.users().hosts().forEach(name -> names.add(inAddress(name)));
        });
    return names;
  }

  /** As it stands in addresses and in the header Host. */
  static String inAddress(String host) {
    String small = host.toLowerCase(Locale.ROOT);
    return small.indexOf(':') < 0 || small.startsWith("[") ? small : "[" + small + "]";
  }

  Access access() {
    return security
        .<Access>map(files -> new PersonsAccess(files.persons(), InstantSource.system()))
        .orElseGet(OpenAccess::new);
  }
}
