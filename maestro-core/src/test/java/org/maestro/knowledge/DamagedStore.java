package org.maestro.knowledge;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;

/** A copy of a store in which one file is cut, gone, or has rubbish in it. */
record DamagedStore(long seed, Path whole) {
  private static final int RUBBISH = 4_096;

  /** Returns where it is. */
  Path in(Path place) throws IOException {
    for (Path from : all(whole)) {
      Path to = place.resolve(whole.relativize(from).toString());
      if (Files.isDirectory(from)) {
        Files.createDirectories(to);
      } else if (!from.endsWith("tdb.lock")) {
        Files.copy(from, to);
      }
    }
    damage(place);
    return place;
  }

  private static List<Path> all(Path directory) throws IOException {
    try (Stream<Path> paths = Files.walk(directory)) {
      return paths.sorted().toList();
    }
  }

  private void damage(Path place) throws IOException {
    Random chance = new Random(seed);
    List<Path> files =
        all(place).stream()
            .filter(file -> Files.isRegularFile(file) && file.toFile().length() > 0)
            .toList();
    Path file = files.get(chance.nextInt(files.size()));
    byte[] bytes = Files.readAllBytes(file);
    switch (chance.nextInt(3)) {
      case 0 -> Files.write(file, Arrays.copyOf(bytes, chance.nextInt(bytes.length)));
      case 1 -> Files.delete(file);
      default -> {
        byte[] rubbish = new byte[Math.min(RUBBISH, bytes.length)];
        chance.nextBytes(rubbish);
        int from = chance.nextInt(bytes.length - rubbish.length + 1);
        System.arraycopy(rubbish, 0, bytes, from, rubbish.length);
        Files.write(file, bytes);
      }
    }
  }
}
