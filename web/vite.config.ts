import { defineConfig } from 'vitest/config';

// Names without hashes: the committed bundle's files keep theirs from one build to the next. The page of shapes is built
// by itself (--mode shapes), since it has to hold all of its script.
export default defineConfig(({ mode }) => ({
  build: {
    emptyOutDir: mode !== 'shapes',
    copyPublicDir: mode !== 'shapes',
    target: 'es2022',
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 700,
    rollupOptions: {
      input: mode === 'shapes' ? { shapes: 'src/shapes.ts' } : { studio: 'index.html', report: 'src/report.ts' },
      output: {
        entryFileNames: 'assets/[name].js',
        chunkFileNames: 'assets/[name].js',
        assetFileNames: 'assets/[name][extname]',
      },
    },
  },
  worker: { rollupOptions: { output: { entryFileNames: 'assets/[name].js' } } },
  test: { include: ['tests/*.test.ts'] },
}));
