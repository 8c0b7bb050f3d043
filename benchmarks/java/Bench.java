// The workloads on Processing's Java core, timed like the others.
//
//   java -cp CORE_AND_JOGL_JARS:FOLDER Bench W1 4 1.5
//
// The arguments are workload, samples for each pixel (1: noSmooth()) and the seconds to measure
// for, after as many to warm up. For each frame it prints the milliseconds inside draw()'s own
// calls, and those until OpenGL has finished.
import java.util.Locale;
import processing.core.PApplet;
import processing.core.PImage;
import processing.core.PShape;
import processing.opengl.PGL;

public class Bench extends PApplet {
  static String workload;
  static int samples;
  static double seconds;
  long firstFrame;

  public static void main(String[] arguments) {
    workload = arguments[0];
    samples = Integer.parseInt(arguments[1]);
    seconds = Double.parseDouble(arguments[2]);
    PApplet.main(new String[] {"Bench"});
  }

  static final java.util.Set<String> IN_3D = java.util.Set.of("W3", "W3s", "W5", "W8");
  PShape big;
  PImage[] sprites = new PImage[4];
  String[] words = new String[1000];

  public void settings() {
    size(640, 480, IN_3D.contains(workload) ? P3D : P2D);
    if (samples == 1) noSmooth();
  }

  public void setup() {
    frameRate(2000);
    if (workload.equals("W6")) strokeWeight(2);
    if (workload.endsWith("s") || workload.equals("W6")) stroke(0);
    else noStroke();
    if (workload.equals("W5")) makeBig();
    if (workload.equals("W7")) makeSprites();
    if (workload.equals("W11")) {
      textSize(12);
      for (int i = 0; i < words.length; i++) words[i] = "item " + i;
    }
  }

  void makeBig() {
    big = createShape();
    big.beginShape(TRIANGLES);
    big.noStroke();
    for (int i = 0; i < 1000; i++) {
      for (int j = 0; j < 500; j++) {
        float x = i * 0.4f - 200;
        float y = j * 0.8f - 200;
        float z = 20 * sin(i * 0.05f) * cos(j * 0.05f);
        big.fill(i & 255, j & 255, 128);
        big.vertex(x, y, z);
        big.vertex(x + 0.4f, y, z);
        big.vertex(x, y + 0.8f, z);
        big.vertex(x + 0.4f, y, z);
        big.vertex(x + 0.4f, y + 0.8f, z);
        big.vertex(x, y + 0.8f, z);
      }
    }
    big.endShape();
  }

  void makeSprites() {
    for (int k = 0; k < 4; k++) {
      sprites[k] = createImage(32, 32, ARGB);
      sprites[k].loadPixels();
      for (int i = 0; i < 1024; i++) {
        sprites[k].pixels[i] = color((i * 3 + k * 40) & 255, i & 255, 200, 255);
      }
      sprites[k].updatePixels();
    }
  }

  public void draw() {
    long start = System.nanoTime();
    if (firstFrame == 0) firstFrame = start;
    drawWorkload();
    long called = System.nanoTime();
    flush();
    PGL pgl = beginPGL();
    pgl.finish();
    endPGL();
    long finished = System.nanoTime();
    double age = (start - firstFrame) / 1e9;
    if (age > seconds) {
      System.out.printf(
          Locale.ROOT, "frame %.4f %.4f%n", (called - start) / 1e6, (finished - start) / 1e6);
    }
    if (age > 2 * seconds && frameCount > 8) {
      System.out.flush();
      Runtime.getRuntime().halt(0);
    }
  }

  void drawWorkload() {
    switch (workload) {
      case "W0":
        background(200);
        break;
      case "W1":
      case "W1s":
        background(200);
        for (int i = 0; i < 10000; i++) {
          fill(i & 255, (i * 7) & 255, (i * 13) & 255);
          rect((i * 37) % width, (i * 53) % height, 8, 8);
        }
        break;
      case "W2":
      case "W2s":
        background(200);
        for (int i = 0; i < 10000; i++) {
          fill(i & 255, (i * 7) & 255, (i * 13) & 255);
          ellipse((i * 37) % width, (i * 53) % height, 10, 10);
        }
        break;
      case "W3":
      case "W3s":
        background(0);
        lights();
        for (int i = 0; i < 1000; i++) {
          pushMatrix();
          translate((i * 37) % width, (i * 53) % height, -(i % 50));
          rotateX(i * 0.01f + frameCount * 0.01f);
          rotateY(i * 0.02f);
          fill(i & 255, 200, 100);
          box(12);
          popMatrix();
        }
        break;
      case "W4":
        background(0);
        fill(255, 100, 50);
        beginShape(TRIANGLES);
        for (int i = 0; i < 33333; i++) {
          float x = (i * 37) % width;
          float y = (i * 53) % height;
          vertex(x, y);
          vertex(x + 4, y);
          vertex(x, y + 4);
        }
        endShape();
        break;
      case "W6":
        background(255);
        for (int i = 0; i < 10000; i++) {
          float x = (i * 37) % width;
          float y = (i * 53) % height;
          line(x, y, x + 24, y + i % 17);
        }
        break;
      case "W5":
        background(0);
        translate(width / 2, height / 2);
        rotateY(frameCount * 0.01f);
        rotateX(frameCount * 0.013f);
        shape(big);
        break;
      case "W7":
        background(0);
        for (int i = 0; i < 1000; i++) {
          tint(i & 255, 255, 128, 200);
          image(sprites[i / 250 & 3], (i * 37) % width, (i * 53) % height, 32, 32);
        }
        break;
      case "W8":
        background(0);
        lights();
        for (int i = 0; i < 500; i++) {
          pushMatrix();
          translate((i * 37) % width, (i * 53) % height, -(i % 50));
          fill(i & 255, 200, 100);
          sphere(20);
          popMatrix();
        }
        break;
      case "W10":
        loadPixels();
        for (int y = 0; y < height; y++) {
          for (int x = 0; x < width; x++) {
            int red = (x + frameCount) & 255;
            pixels[y * width + x] = 0xff000000 | red << 16 | (y & 255) << 8 | 128;
          }
        }
        updatePixels();
        break;
      case "W11":
        background(255);
        fill(0);
        for (int i = 0; i < 1000; i++) {
          text(words[i], (i * 37) % width, (i * 53) % height);
        }
        break;
      default:
        throw new IllegalArgumentException(workload);
    }
  }
}
