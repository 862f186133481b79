package org.maestro.platform;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.maestro.agents.lives.AgentLives;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.HomeFaultException;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.Individual;
import org.maestro.rats.security.WatchedFiles;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The permissions in the file of a home: when it has changed they are read anew, and count from the
 * next call on, while all else in it stays as it was read at the start (ADE, 3.1; A28). A file with
 * faults changes nothing.
 */
final class PermissionsFile {
  private static final Logger LOG = LoggerFactory.getLogger(PermissionsFile.class);

  /** Wall time. */
  private static final Duration LOOKED_EVERY = Duration.ofSeconds(1);

  private final Path file;
  private final WatchedFiles watched;
  private final KnowledgeBase knowledge;
  private final Clock clock;
  private final AgentLives lives;

  PermissionsFile(Path file, KnowledgeBase knowledge, Clock clock, AgentLives lives) {
    this.file = file;
    this.watched = new WatchedFiles(List.of(file));
    this.knowledge = knowledge;
    this.clock = clock;
    this.lives = lives;
  }

  void watch() {
    clock.schedule(clock.ofWall(LOOKED_EVERY), "permissions", this::begin);
  }

  /** To read a home takes long, so it is not for the clock's thread. */
  private void begin() {
    if (lives.areOver()) {
      return;
    }
    Thread looking = new Thread(this::look, "permissions");
    looking.setDaemon(true);
    looking.start();
  }

  private void look() {
    try {
      if (watched.haveChanged()) {
        read();
      }
    } finally {
      watch();
    }
  }

  private void read() {
    try {
      Map<String, Individual> stated = new HomeLoader().load(file).permissions();
      if (!lives.areOver() && !stated.equals(knowledge.home().permissions())) {
        LOG.info("The permissions of {} have changed: there are {}", file, stated.size());
        knowledge.permit(stated);
      }
    } catch (HomeFaultException faulty) {
      LOG.warn(
          "The permissions stay as they were, as {} has faults: {}", file, faulty.getMessage());
    }
  }
}
