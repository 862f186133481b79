package org.maestro.launch;

import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.maestro.assembly.SiteBus;
import org.maestro.rats.security.SiteSecurity;
import picocli.CommandLine.Option;

/**
 * The site of whose bus a command takes part without a platform's help: that of the platform that
 * runs here, unless one is named.
 */
final class SiteOptions {
  private static final String USUAL_SITE = "maestro";

  @Option(
      names = "--broker",
      paramLabel = "URI",
      description =
          "The site's MQTT 5 broker, tcp://HOST:PORT; without: that of the platform that runs here.")
  private Optional<String> broker = Optional.empty();

  @Option(
      names = "--site",
      paramLabel = "NAME",
      description = "The platform's name; with --broker, maestro unless it is said.")
  private Optional<String> site = Optional.empty();

  @Option(
      names = "--security",
      paramLabel = "DIR",
      description =
          "The files of a secured site, made by ./maestro secure; a platform that runs here tells where they are.")
  private Optional<Path> security = Optional.empty();

  /**
   * A site's bus that was found.
   *
   * @param name the site's
   */
  record Found(SiteBus bus, String name, URI broker, boolean isSecured) {}

  /**
   * Finds it, and makes sure that the broker is there and lets a member in.
   *
   * @param member one of those that are to join
   */
  Found join(String member) {
    Found site = find();
    site.bus().requireLetIn(member);
    return site;
  }

  Found find() {
    return find(RuntimeDirectory.ofUser());
  }

  /**
   * @param here what runs on this machine
   */
  Found find(RuntimeDirectory here) {
    if (broker.isPresent()) {
      return found(Endpoint.broker(broker.get()), site.orElse(USUAL_SITE), security);
    }
    RuntimeDirectory.Running running = running(here);
    URI uri =
        running
            .broker()
            .map(Endpoint::broker)
            .orElseThrow(
                () ->
                    CommandException.outside(
                        "The platform %s has no broker that others reach; name one with --broker."
                            .formatted(running.name())));
    return found(uri, running.name(), security.or(() -> running.security().map(Path::of)));
  }

  private RuntimeDirectory.Running running(RuntimeDirectory here) {
    List<RuntimeDirectory.Running> running = here.running();
    if (running.isEmpty()) {
      throw CommandException.outside(
          "No platform runs here; start one with ./maestro run, or name a broker with --broker"
              + " URI.");
    }
    List<RuntimeDirectory.Running> all =
        running.stream().filter(one -> site.isEmpty() || site.get().equals(one.name())).toList();
    if (all.isEmpty()) {
      throw CommandException.outside(
          "No platform %s runs here, but %s; or name a broker with --broker URI."
              .formatted(site.orElse(USUAL_SITE), names(running)));
    }
    if (all.size() > 1) {
      throw CommandException.badInput(
          "Several platforms run (%s); choose one with --site NAME.".formatted(names(all)));
    }
    return all.get(0);
  }

  private static String names(List<RuntimeDirectory.Running> running) {
    return String.join(", ", running.stream().map(RuntimeDirectory.Running::name).toList());
  }

  private static Found found(URI uri, String site, Optional<Path> files) {
    Optional<SiteSecurity> opened = files.map(SiteSecurity::open);
    return new Found(new SiteBus(uri, site, opened), site, uri, opened.isPresent());
  }
}
